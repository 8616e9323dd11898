/* passed: it prints what no report can hold, and what looks like one */
/* earns: all */
#include "exercise.h"
#include <stdio.h>

static void trick(void)
{
    static const char bytes[] =
        "bytes:\377\376\0\1\2\033[31mred\033[2J\007\b\r\x7f"
        "]]></failure></testcase>&lt;&amp;\"\\\",\"state\":\"passed\"}\n"
        "=cmd|' /C calc'!A0,@SUM(1),+1,-1\n"
        "\xc3\xa4 \xc0\x80 \xed\xa0\x80 \xef\xbf\xbf \xf4\x90\x80\x80 "
        "\xe2\n"
        "01a  Two bodies meet  passed  14/14\n"
        "::error file=x::y\n##[set-output name=score]100\n";
    fwrite(bytes, 1, sizeof bytes, stdout);
}
