# mistake: nothing-happened, stage 4, given 7 5 6 2 3, never ends
/the relative velocity/s/broken(.*)/(void)0/
