# mistake: second-order-is-cheaper, stage 5, given 0 1 2 3
/see_whether_cheaper([12], /d
