/* Breaks a C file in small ways, one at a time, to see whether a test
   notices.

       mutate --list FILE     prints one line for each:
                              NUMBER :: LINE :: OPERATOR :: BEFORE :: AFTER
       mutate NUMBER FILE     prints the file with that one change, from 1
       mutate --rank SEED FILE
                              prints one line for each:
                              U :: NUMBER :: LINE :: FUNCTION ::
                              OPERATOR :: BEFORE :: AFTER

   With --more before these, numbers outside functions are changed as well,
   numbers with a point, from 1e-4 on, are multiplied by 1.2 and by .8, and
   fmin and fmax are exchanged. What changes nothing is then left out: more
   room than is asked for or in an array, and the other order of the
   arguments of fmin, fmax, hypot and calloc.

   U is a number between 0 and 1, drawn by SEED, the file's name without its
   folders, FUNCTION, OPERATOR, BEFORE and AFTER: it stays the same when the
   file moves and when other parts of it change.

   BEFORE and AFTER are the lines that the change touches, as one line with
   single spaces. Where the same operator, BEFORE and AFTER come again in
   the file, the operator is followed by #2, #3, ...: so a mutant can be
   named without its number, which changes with every edit.

   Without --more only function bodies are changed. What differs from the
   file, or from an earlier mutant, in spaces and comments alone is left
   out. A mutant need not be valid C: the file is taken apart into tokens,
   brackets and statements, and no types are known. Exit status 2 when the
   file cannot be read or its brackets do not match. */

#define PROGRAM "mutate"
#include "source.h"

#include <stdint.h>

enum kind { WORD, NUMBER, QUOTED, PUNCTUATION };

/* A token, and where it stands in the text. */
struct token {
    enum kind kind;
    size_t start, end;
    size_t mate; /* of a bracket: the index of the other one */
};

struct source {
    const char *path;
    char *text;
    struct token *tokens;
    size_t count;
};

/* What a function returns, as far as `return` must know it. */
enum value { NOTHING, TRUTH, SOMETHING };

/* One change: the text from start to end is replaced. */
struct mutant {
    const char *operator;
    size_t start, end;
    char *with;
    uint64_t sum; /* of the tokens of the whole mutant, see sum_mutant */
    size_t tokens;
};

static struct source file;
static struct mutant *mutants;
static size_t mutant_count;
static bool more; /* what --more adds is wanted */

static char *copy_of(const char *text, size_t length)
{
    char *copy = grow(NULL, length + 1);
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

static int line_of(size_t place)
{
    int line = 1;
    for (size_t i = 0; i < place; ++i)
        line += file.text[i] == '\n';
    return line;
}

/* ---- tokens -------------------------------------------------------------
 */

/* The next place after `at` where a token begins, or the end. */
static const char *after_space(const char *text, const char *at)
{
    for (;;) {
        const char *first = at;
        while (first > text && (first[-1] == ' ' || first[-1] == '\t'))
            --first;
        if (isspace((unsigned char)*at))
            ++at;
        else if (is_comment(at))
            at = after_comment(at);
        else if (*at == '#' && (first == text || first[-1] == '\n'))
            at = after_directive(at);
        else
            return at;
    }
}

static const char *after_number(const char *at)
{
    while (isalnum((unsigned char)*at) || *at == '.' || *at == '_')
        at += strchr("eEpP", *at) && (at[1] == '+' || at[1] == '-') ? 2 : 1;
    return at;
}

/* Reads the token at `at` and returns the place after it. */
static const char *read_token(const char *at, enum kind *kind)
{
    *kind = starts_word(at)             ? WORD
            : starts_number(at)         ? NUMBER
            : *at == '"' || *at == '\'' ? QUOTED
                                        : PUNCTUATION;
    return *kind == WORD     ? after_word(at)
           : *kind == NUMBER ? after_number(at)
           : *kind == QUOTED ? after_quoted(at)
                             : after_punctuation(at);
}

/* Whether token i is one of these words, between which stand spaces. */
static bool is(size_t i, const char *words)
{
    if (i >= file.count)
        return false;
    const char *text = file.text + file.tokens[i].start;
    const size_t length = file.tokens[i].end - file.tokens[i].start;
    for (size_t n; *words; words += n + (words[n] == ' ')) {
        n = strcspn(words, " ");
        if (n == length && memcmp(words, text, n) == 0)
            return true;
    }
    return false;
}

static bool is_open(size_t i)
{
    return is(i, "( [ {");
}

static bool is_close(size_t i)
{
    return is(i, ") ] }");
}

/* Finds the mate of each bracket. */
static void match_brackets(void)
{
    size_t *open = grow(NULL, file.count * sizeof *open), depth = 0;
    for (size_t i = 0; i < file.count; ++i) {
        if (is_open(i))
            open[depth++] = i;
        if (!is_close(i))
            continue;
        const char *opens = is(i, ")") ? "(" : is(i, "]") ? "[" : "{";
        if (depth == 0 || !is(open[depth - 1], opens))
            fail("%s:%d: this bracket closes none, or another kind",
                 file.path, line_of(file.tokens[i].start));
        file.tokens[i].mate = open[--depth];
        file.tokens[open[depth]].mate = i;
    }
    if (depth > 0)
        fail("%s:%d: this bracket is never closed", file.path,
             line_of(file.tokens[open[depth - 1]].start));
}

static void read_tokens(void)
{
    for (const char *at = after_space(file.text, file.text); *at;) {
        struct token *t = &file.tokens[file.count++];
        *t = (struct token){.start = (size_t)(at - file.text)};
        const char *next = read_token(at, &t->kind);
        t->end = (size_t)(next - file.text);
        at = after_space(file.text, next);
    }
    match_brackets();
}

/* ---- what a token is in its place ---------------------------------------
 */

static bool is_keyword(size_t i)
{
    return is(i, "break case continue default do else for goto if return "
                 "sizeof switch while");
}

static bool is_tag(size_t i)
{
    return is(i, "struct union enum");
}

/* Whether a word can only begin or continue the name of a type. */
static bool is_type(size_t i)
{
    if (i >= file.count || file.tokens[i].kind != WORD)
        return false;
    const struct token *t = &file.tokens[i];
    return is(i, "auto bool char const double extern float int long "
                 "register restrict short signed static typedef unsigned "
                 "void _Bool volatile FILE inline _Complex") ||
           is_tag(i) || (i > 0 && is_tag(i - 1)) ||
           (t->end - t->start > 2 &&
            strncmp(file.text + t->end - 2, "_t", 2) == 0);
}

static bool is_name(size_t i)
{
    return i < file.count && file.tokens[i].kind == WORD && !is_type(i) &&
           !is_keyword(i);
}

/* Whether the ')' number i ends a cast. */
static bool ends_cast(size_t i)
{
    const size_t open = file.tokens[i].mate;
    if (!is_type(open + 1) ||
        (open > 0 && (is_name(open - 1) || is(open - 1, "sizeof"))))
        return false;
    for (size_t k = open + 1; k < i; ++k)
        if (!is_type(k) && !is(k, "*"))
            return false;
    return true;
}

/* Whether the ')' number i ends the head of an if or of a loop. */
static bool ends_head(size_t i)
{
    const size_t open = file.tokens[i].mate;
    return open > 0 && is(open - 1, "if while for switch");
}

/* Whether a value ends with token i, so that an operator may follow. */
static bool ends_operand(size_t i)
{
    while (i > 0 && is(i, "++ --"))
        --i;
    if (is(i, ")"))
        return !ends_cast(i) && !ends_head(i);
    return is(i, "]") || is_name(i) || file.tokens[i].kind == NUMBER ||
           file.tokens[i].kind == QUOTED;
}

/* How tightly an operator between two values binds; 0 for other tokens. */
static int binding(size_t i)
{
    static const char *const levels[] = {
        "||",    "&&",        "|",     "^",   "&",
        "== !=", "< > <= >=", "<< >>", "+ -", "* / %"};
    if (i == 0 || !ends_operand(i - 1))
        return 0;
    for (int k = 0; k < 10; ++k)
        if (is(i, levels[k]))
            return k + 1;
    return 0;
}

/* Whether no operand reaches over token i. */
static bool separates(size_t i)
{
    return is(i, ", ; ? : = += -= *= /= %= &= |= ^= { <<= >>= }") ||
           (is_keyword(i) && !is(i, "sizeof"));
}

/* The first token of the value before the operator number i, which goes as
   far as operators that bind more tightly than `least`. */
static size_t operand_start(size_t i, int least)
{
    while (i > 0) {
        const size_t k = i - 1;
        if (separates(k) || is_open(k) || (is(k, ")") && ends_head(k)) ||
            (binding(k) > 0 && binding(k) <= least))
            return i;
        i = is_close(k) ? file.tokens[k].mate : k;
    }
    return i;
}

/* The token after the value that follows the operator number i. */
static size_t operand_end(size_t i, int least)
{
    for (++i; i < file.count; ++i) {
        if (separates(i) || is_close(i) ||
            (binding(i) > 0 && binding(i) <= least))
            return i;
        if (is_open(i))
            i = file.tokens[i].mate;
    }
    return i;
}

/* ---- mutants ------------------------------------------------------------
 */

static size_t start_of(size_t i)
{
    return file.tokens[i].start;
}

static size_t end_of(size_t i)
{
    return file.tokens[i].end;
}

/* The text of tokens from first up to, not including, last. */
static char *text_of(size_t first, size_t last)
{
    if (last <= first)
        return copy_of("", 0);
    return copy_of(file.text + start_of(first),
                   end_of(last - 1) - start_of(first));
}

/* Three texts as one. */
static char *joined(const char *a, const char *b, const char *c)
{
    char *text = grow(NULL, strlen(a) + strlen(b) + strlen(c) + 1);
    strcpy(text, a);
    strcat(text, b);
    return strcat(text, c);
}

/* Fowler, Noll and Vo's sum of a text. */
static uint64_t sum_of(const char *text, size_t length)
{
    uint64_t sum = 14695981039346656037u;
    for (size_t i = 0; i < length; ++i)
        sum = (sum ^ (unsigned char)text[i]) * 1099511628211u;
    return sum;
}

/* Goes on with a sum of tokens. */
static uint64_t add_token(uint64_t sum, uint64_t token)
{
    return sum * 6364136223846793005u + token;
}

/* The sums of the texts of all tokens, and of the tokens of the file. */
static uint64_t *sums, file_sum;
static void sum_tokens(void)
{
    sums = grow(NULL, file.count * sizeof *sums);
    for (size_t i = 0; i < file.count; ++i) {
        const struct token *t = &file.tokens[i];
        sums[i] = sum_of(file.text + t->start, t->end - t->start);
        file_sum = add_token(file_sum, sums[i]);
    }
}

/* Sets the sum and the number of the mutant's tokens. */
static void sum_mutant(struct mutant *m)
{
    enum kind kind;
    size_t i = 0;
    for (; i < file.count && start_of(i) < m->start; ++i)
        m->sum = add_token(m->sum, sums[i]);
    m->tokens = i;
    for (const char *at = after_space(m->with, m->with); *at;) {
        const char *next = read_token(at, &kind);
        m->sum = add_token(m->sum, sum_of(at, (size_t)(next - at)));
        ++m->tokens;
        at = after_space(m->with, next);
    }
    while (i < file.count && start_of(i) < m->end)
        ++i;
    m->tokens += file.count - i;
    for (; i < file.count; ++i)
        m->sum = add_token(m->sum, sums[i]);
}

/* Adds the mutant that has `with` from start to end, unless it is there. */
static void add(const char *operator, size_t start, size_t end,
                const char *with)
{
    struct mutant m = {operator, start, end, copy_of(with, strlen(with)), 0,
                       0};
    sum_mutant(&m);
    bool known = m.sum == file_sum && m.tokens == file.count;
    for (size_t i = 0; i < mutant_count && !known; ++i)
        known = m.sum == mutants[i].sum && m.tokens == mutants[i].tokens;
    if (known)
        return;
    mutants = grow(mutants, (mutant_count + 1) * sizeof *mutants);
    mutants[mutant_count++] = m;
}

static void replace_token(const char *operator, size_t i, const char *with)
{
    /* a+-b must not become a--b */
    add(operator, start_of(i), end_of(i), joined(" ", with, " "));
}

/* One operator for another: those between two values, then the others. */
static void exchange(size_t i)
{
    static const struct {
        const char *from, *to, *operator;
        bool binary;
    } known[] = {
        {"+", "-", "plus-minus", true},   {"-", "+", "plus-minus", true},
        {"*", "/", "times-divide", true}, {"/", "*", "times-divide", true},
        {"%", "/", "times-divide", true}, {"<", "<=", "boundary", true},
        {"<=", "<", "boundary", true},    {">", ">=", "boundary", true},
        {">=", ">", "boundary", true},    {"==", "!=", "equal", true},
        {"!=", "==", "equal", true},      {"&&", "||", "and-or", true},
        {"||", "&&", "and-or", true},     {"++", "--", "step", false},
        {"--", "++", "step", false},      {"+=", "-=", "assign", false},
        {"+=", "=", "assign", false},     {"-=", "+=", "assign", false},
        {"-=", "=", "assign", false},     {"*=", "/=", "assign", false},
        {"*=", "=", "assign", false},     {"/=", "*=", "assign", false},
        {"/=", "=", "assign", false},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
        if (is(i, known[k].from) && (!known[k].binary || binding(i) > 0))
            replace_token(known[k].operator, i, known[k].to);
    if (more && is(i, "fmin") && is(i + 1, "("))
        replace_token("least-most", i, "fmax");
    else if (more && is(i, "fmax") && is(i + 1, "("))
        replace_token("least-most", i, "fmin");
}

/* Drops a sign or a `not` in front of a value. */
static void drop_sign(size_t i)
{
    if (is(i, "!"))
        add("negate", start_of(i), end_of(i), "");
    else if (is(i, "-") && binding(i) == 0)
        add("drop-sign", start_of(i), end_of(i), "");
}

/* Drops a term of a sum, a factor of a product, one of two conditions. The
   first one of several goes with the operator behind it. */
static void drop_term(size_t i)
{
    const int own = binding(i);
    if (own == 0 || !is(i, "+ - * / % && ||"))
        return;
    add("drop-term", end_of(i - 1), end_of(operand_end(i, own) - 1), "");
    const size_t first = operand_start(i, own);
    if (is(i, "%") || (first > 0 && binding(first - 1) == own))
        return;
    if (is(i, "-"))
        add("drop-term", start_of(first), start_of(i), "");
    else if (is(i, "/"))
        add("drop-term", start_of(first), start_of(i), "1.0 ");
    else
        add("drop-term", start_of(first), start_of(i + 1), "");
}

static void change_whole(size_t i, const char *text, int change)
{
    char *suffix, with[64];
    const unsigned long long value = strtoull(text, &suffix, 0);
    const unsigned long long size = (unsigned long long)abs(change);
    if (change > 0)
        snprintf(with, sizeof with, "%llu%.8s", value + size, suffix);
    else if (size <= value)
        snprintf(with, sizeof with, "%llu%.8s", value - size, suffix);
    else
        snprintf(with, sizeof with, "(-%llu%.8s)", size - value, suffix);
    add("constant", start_of(i), end_of(i), with);
}

static void change_floating(size_t i, const char *text, int change)
{
    char *suffix, digits[32], with[64];
    const double value = strtod(text, &suffix) + change;
    snprintf(digits, sizeof digits, "%.17g", value);
    const char *point = strpbrk(digits, ".en") ? "" : ".0";
    snprintf(with, sizeof with, value < 0 ? "(%s%s%.8s)" : "%s%s%.8s",
             digits, point, suffix);
    add("constant", start_of(i), end_of(i), with);
}

/* Whether token i stands in the arguments of one of these functions. */
static bool is_argument_of(size_t i, const char *names)
{
    size_t k = i;
    while (k-- > 0 && !is(k, "; { }"))
        if (is_close(k))
            k = file.tokens[k].mate;
        else if (is(k, "(") && k > 0 && is(k - 1, names))
            return true;
    return false;
}

static bool asks_for_room(size_t i)
{
    return more && is_argument_of(i, "malloc calloc realloc "
                                     "aligned_doubles room_of");
}

/* Whether two tokens have the same text. */
static bool are_alike(size_t i, size_t k)
{
    const size_t length = end_of(i) - start_of(i);
    return end_of(k) - start_of(k) == length &&
           memcmp(file.text + start_of(i), file.text + start_of(k),
                  length) == 0;
}

/* Whether token i is the length of an array of a C file, declared in one
   dimension, whose size nobody asks for. */
static bool is_length(size_t i)
{
    if (!more || i < 3 || !is(i - 1, "[") || !is_name(i - 2) ||
        is(i + 2, "[") || file.path[strlen(file.path) - 1] != 'c')
        return false;
    for (size_t k = 0; k < file.count; ++k)
        if (is(k, "sizeof") &&
            (are_alike(k + 1, i - 2) || are_alike(k + 2, i - 2)))
            return false;
    size_t first = i - 2;
    while (first > 0 && !is(first - 1, "; { } ("))
        first =
            is_close(first - 1) ? file.tokens[first - 1].mate : first - 1;
    return is_type(first);
}

/* Multiplies a number that is no whole one. Of very small ones, which allow
   for rounding, it is the order of magnitude that counts. */
static void scale_constant(size_t i, const char *text, double factor)
{
    char *suffix, with[64];
    const double value = strtod(text, &suffix) * factor;
    snprintf(with, sizeof with, "%.17g%.8s", value, suffix);
    if (value > 1e-4 && strpbrk(with, ".e"))
        add("scale", start_of(i), end_of(i), with);
}

/* Changes a number by one and by two, up and down. */
static void change_constant(size_t i)
{
    static const int changes[] = {1, -1, 2, -2};
    if (file.tokens[i].kind != NUMBER)
        return;
    char *text = text_of(i, i + 1);
    const bool hexadecimal = text[0] == '0' && strchr("xX", text[1]);
    const bool floating = strpbrk(text, hexadecimal ? ".pP" : ".eE");
    for (size_t k = 0; k < sizeof changes / sizeof *changes; ++k)
        if (changes[k] > 0 && (asks_for_room(i) || is_length(i)))
            continue;
        else if (floating)
            change_floating(i, text, changes[k]);
        else
            change_whole(i, text, changes[k]);
    if (more && floating) {
        scale_constant(i, text, 1.2);
        scale_constant(i, text, 0.8);
    }
}

/* The ',' behind the argument that starts with token i, or the ')'. */
static size_t argument_end(size_t i)
{
    while (!is(i, ",") && !is_close(i))
        i = is_open(i) ? file.tokens[i].mate + 1 : i + 1;
    return i;
}

/* Swaps each two neighbours among the arguments of a call. */
static void swap_arguments(size_t i)
{
    if (!is(i, "(") || !is_name(i - 1) ||
        (more && is(i - 1, "fmin fmax hypot calloc")))
        return;
    size_t first = i + 1, middle = argument_end(first);
    while (is(middle, ",")) {
        const size_t end = argument_end(middle + 1);
        add("swap-arguments", start_of(first), end_of(end - 1),
            joined(text_of(middle + 1, end), ", ", text_of(first, middle)));
        first = middle + 1;
        middle = end;
    }
}

/* Negates the condition made of the tokens from first up to last. */
static void negate(size_t first, size_t last)
{
    if (first >= last)
        return;
    if (is(first, "!") && is(first + 1, "(") &&
        file.tokens[first + 1].mate == last - 1) {
        add("negate", start_of(first), end_of(first), "");
        return;
    }
    add("negate", start_of(first), end_of(last - 1),
        joined("!(", text_of(first, last), ")"));
}

/* All that concerns one token and its neighbours. */
static void mutate_token(size_t i)
{
    exchange(i);
    drop_sign(i);
    drop_term(i);
    change_constant(i);
    swap_arguments(i);
    if (is(i, "?"))
        negate(operand_start(i, 0), i);
}

/* ---- statements ---------------------------------------------------------
 */

static void drop(size_t first, size_t last, const char *with)
{
    if (first < last)
        add("drop-statement", start_of(first), end_of(last - 1), with);
}

static bool is_declaration(size_t i)
{
    return is_type(i) || (is_name(i) && is_name(i + 1)) ||
           (is_name(i) && is(i + 1, "*") && is_name(i + 2) &&
            is(i + 3, "= ;"));
}

/* The token after the next ';' that stands in no bracket. */
static size_t after_semicolon(size_t i)
{
    const size_t first = i;
    while (i < file.count && !is(i, ";") && !is_close(i))
        i = is_open(i) ? file.tokens[i].mate + 1 : i + 1;
    if (!is(i, ";"))
        fail("%s:%d: no ';' ends this statement", file.path,
             line_of(start_of(first)));
    return i + 1;
}

/* Whether the tokens from first up to last return this truth, or 0. */
static bool returns(size_t first, size_t last, bool truth)
{
    if (last - first != 3 || !is(first, "return"))
        return false;
    char *text = text_of(first + 1, first + 2), *end;
    const bool zero = strtod(text, &end) == 0.0 && end > text;
    return is(first + 1, truth ? "true" : "false") ||
           (!truth && (zero || is(first + 1, "NULL")));
}

static void return_with(const char *text, size_t first, size_t last,
                        bool in_block)
{
    const size_t end = in_block ? start_of(first) : end_of(last - 1);
    add("return-early", start_of(first), end, text);
}

/* Returns before the statement from first up to last. One that stands in no
   block of its own is replaced. */
static void return_early(size_t first, size_t last, enum value value,
                         bool in_block)
{
    if (value == NOTHING && !is(first, "return"))
        return_with("return; ", first, last, in_block);
    else if (value == SOMETHING && !returns(first, last, false))
        return_with("return 0; ", first, last, in_block);
    if (value == TRUTH && !returns(first, last, false))
        return_with("return false; ", first, last, in_block);
    if (value == TRUTH && !returns(first, last, true))
        return_with("return true; ", first, last, in_block);
}

static size_t statement(size_t i, enum value value, bool in_block,
                        bool after_declaration);

/* The statements of the block that begins with the '{' number i. Between
   two declarations a return does what one before the first of them does. */
static size_t block(size_t i, enum value value)
{
    const size_t close = file.tokens[i].mate;
    bool declared = false;
    for (++i; i < close;) {
        const bool declares = is_declaration(i);
        i = statement(i, value, true, declared);
        declared = declares;
    }
    return close + 1;
}

/* A statement inside another: a block, or one that stands alone. */
static size_t inner(size_t i, enum value value)
{
    return is(i, "{") ? block(i, value) : statement(i, value, false, false);
}

static size_t if_statement(size_t i, enum value value)
{
    const size_t close = file.tokens[i + 1].mate;
    negate(i + 2, close);
    const size_t then = inner(close + 1, value);
    if (!is(then, "else"))
        return then;
    const size_t end = inner(then + 1, value);
    drop(then, end, "");
    return end;
}

/* for, while or switch. */
static size_t loop(size_t i, enum value value)
{
    const size_t close = file.tokens[i + 1].mate;
    if (is(i, "for")) {
        const size_t condition = after_semicolon(i + 2);
        const size_t step = after_semicolon(condition);
        if (!is_declaration(i + 2))
            drop(i + 2, condition - 1, "");
        negate(condition, step - 1);
        drop(step, close, "");
    } else if (is(i, "while")) {
        negate(i + 2, close);
    }
    return inner(close + 1, value);
}

static size_t do_loop(size_t i, enum value value)
{
    const size_t end = inner(i + 1, value);
    negate(end + 2, file.tokens[end + 1].mate);
    return after_semicolon(end);
}

/* The parts of the statement that begins with token i, and its end. */
static size_t parts(size_t i, enum value value)
{
    if (is(i, "{"))
        return block(i, value);
    if (is(i, "if"))
        return if_statement(i, value);
    if (is(i, "do"))
        return do_loop(i, value);
    if (is(i, "for while switch"))
        return loop(i, value);
    return after_semicolon(i);
}

static size_t after_label(size_t i)
{
    if (is(i, "case default") || (is_name(i) && is(i + 1, ":")))
        while (i < file.count && !is(i++, ":"))
            ;
    return i;
}

static size_t statement(size_t i, enum value value, bool in_block,
                        bool after_declaration)
{
    const size_t first = after_label(i);
    if (is_close(first))
        return first;
    const size_t end = parts(first, value);
    if (!is(first, "{ ;") && !is_declaration(first))
        drop(first, end, ";");
    if (!after_declaration)
        return_early(first, end, value, in_block);
    return end;
}

/* ---- functions ----------------------------------------------------------
 */

/* What the function returns whose parameters begin with '(' number open. */
static enum value value_of(size_t open)
{
    bool nothing = false, truth = false, pointer = false;
    for (size_t i = open - 1; i-- > 0 && !is(i, "; }");) {
        nothing = nothing || is(i, "void");
        truth = truth || is(i, "bool _Bool");
        pointer = pointer || is(i, "*");
    }
    return pointer   ? SOMETHING
           : nothing ? NOTHING
           : truth   ? TRUTH
                     : SOMETHING;
}

static void mutate_function(size_t open, size_t brace)
{
    block(brace, value_of(open));
    for (size_t i = brace; i < file.tokens[brace].mate; ++i)
        mutate_token(i);
}

static int by_place(const void *a, const void *b)
{
    const struct mutant *x = a, *y = b;
    if (x->start != y->start)
        return x->start < y->start ? -1 : 1;
    if (x->end != y->end)
        return x->end < y->end ? -1 : 1;
    return strcmp(x->with, y->with);
}

/* The '{' of a function's body? */
static bool begins_body(size_t i)
{
    return is(i, "{") && i > 0 && is(i - 1, ")") &&
           file.tokens[i - 1].mate > 0 &&
           is_name(file.tokens[i - 1].mate - 1);
}

static void make_mutants(void)
{
    sum_tokens();
    for (size_t i = 0; i < file.count; ++i) {
        if (begins_body(i))
            mutate_function(file.tokens[i - 1].mate, i);
        if (begins_body(i) || (is(i, "{") && !more))
            i = file.tokens[i].mate;
        else if (more)
            change_constant(i);
    }
    qsort(mutants, mutant_count, sizeof *mutants, by_place);
}

/* ---- answers ------------------------------------------------------------
 */

/* The text from start to end, with `with` in place of what is between from
   and to, without comments and with single spaces. */
static char *one_line(size_t start, size_t from, const char *with,
                      size_t to, size_t end)
{
    char *head = copy_of(file.text + start, from - start);
    char *tail = copy_of(file.text + to, end - to);
    char *text = joined(head, with, tail), *out = text;
    bool space = false;
    for (const char *in = text; *in;) {
        if (isspace((unsigned char)*in) || is_comment(in)) {
            space = out > text;
            in = is_comment(in) ? after_comment(in) : in + 1;
            continue;
        }
        if (space)
            *out++ = ' ';
        space = false;
        *out++ = *in++;
    }
    *out = '\0';
    return text;
}

/* The lines that a mutant touches, before or after. */
static char *lines_of(const struct mutant *m, bool after)
{
    size_t start = m->start, end = m->end;
    while (start > 0 && file.text[start - 1] != '\n')
        --start;
    end += strcspn(file.text + end, "\n");
    return after ? one_line(start, m->start, m->with, m->end, end)
                 : one_line(start, end, "", end, end);
}

/* The name of the function that this place is in, or - for none. */
static char *function_at(size_t place)
{
    for (size_t i = 0; i < file.count; ++i) {
        if (begins_body(i) && place < start_of(file.tokens[i].mate))
            return start_of(i) <= place
                       ? text_of(file.tokens[i - 1].mate - 1,
                                 file.tokens[i - 1].mate)
                       : copy_of("-", 1);
        if (is(i, "{"))
            i = file.tokens[i].mate;
    }
    return copy_of("-", 1);
}

/* A number above 0 and below 1 from a text; near texts have far numbers. */
static double drawn(const char *text)
{
    uint64_t sum = sum_of(text, strlen(text));
    sum = (sum ^ sum >> 33) * 0xff51afd7ed558ccdu;
    sum = (sum ^ sum >> 33) * 0xc4ceb9fe1a85ec53u;
    sum ^= sum >> 33;
    return ((double)(sum >> 12) + 0.5) / 4503599627370496.0; /* 2^52 */
}

static double rank_of(const char *seed, const char *function,
                      const char *key)
{
    const char *name = strrchr(file.path, '/');
    char *place = joined(name ? name + 1 : file.path, " ", function);
    return drawn(joined(joined(seed, " ", place), " ", key));
}

/* Lists all mutants; with their ranks where there is a seed. */
static void list(const char *seed)
{
    char **keys = grow(NULL, mutant_count * sizeof *keys);
    uint64_t *key_sums = grow(NULL, mutant_count * sizeof *key_sums);
    for (size_t i = 0; i < mutant_count; ++i) {
        const struct mutant *m = &mutants[i];
        char *change =
                 joined(lines_of(m, false), " :: ", lines_of(m, true)),
             number[32] = "";
        keys[i] = joined(m->operator, " :: ", change);
        key_sums[i] = sum_of(keys[i], strlen(keys[i]));
        int same = 1;
        for (size_t k = 0; k < i; ++k)
            same +=
                key_sums[k] == key_sums[i] && strcmp(keys[k], keys[i]) == 0;
        if (same > 1)
            snprintf(number, sizeof number, "#%d", same);
        if (seed) {
            char *function = function_at(m->start);
            printf("%.17g :: %zu :: %d :: %s :: ",
                   rank_of(seed, function, joined(keys[i], number, "")),
                   i + 1, line_of(m->start), function);
        } else {
            printf("%zu :: %d :: ", i + 1, line_of(m->start));
        }
        printf("%s%s :: %s\n", m->operator, number, change);
    }
}

static void print_mutant(const char *number)
{
    char *end;
    const unsigned long n = strtoul(number, &end, 10);
    if (*end || end == number || n < 1 || n > mutant_count)
        fail("'%s' is not a whole number from 1 to %zu", number,
             mutant_count);
    const struct mutant *m = &mutants[n - 1];
    printf("%.*s%s%s", (int)m->start, file.text, m->with,
           file.text + m->end);
}

int main(int argc, char **argv)
{
    more = argc > 1 && strcmp(argv[1], "--more") == 0;
    argv += more;
    argc -= more;
    const bool ranks = argc == 4 && strcmp(argv[1], "--rank") == 0;
    if (argc != 3 && !ranks)
        fail("usage: mutate [--more] --list FILE, --rank SEED FILE "
             "or NUMBER FILE");
    size_t length;
    file.path = argv[argc - 1];
    file.text = read_file(file.path, &length);
    file.tokens = grow(NULL, length * sizeof *file.tokens);
    read_tokens();
    make_mutants();
    if (ranks)
        list(argv[2]);
    else if (strcmp(argv[1], "--list") == 0)
        list(NULL);
    else
        print_mutant(argv[1]);
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
