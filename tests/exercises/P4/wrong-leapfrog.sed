# mistake: fourth-order-is-cheaper, stage 4, given 0 1 2 3
/see_whether_cheaper([14], /d
