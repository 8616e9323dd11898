# mistake: rest-length-forgotten, stage 1
s/(1 - spring\[k\].rest/(1 - 0 * spring[k].rest/
