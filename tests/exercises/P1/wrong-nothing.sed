# mistake: nothing-happened, stage 4
/the relative velocity/s/broken(.*)/(void)0/
