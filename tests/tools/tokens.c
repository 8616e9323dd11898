/* Compares C functions word by word, whatever the names in them.

       tokens FILE...
           prints one line for each function body:
           FILE:LINE: NAME: its tokens

       tokens --shared K FILE... -- BOOK...
           compares each function body of the files before the -- with each
           one of the files after it, prints the longest run of tokens that
           the two share where it has K tokens or more, and then one line
           `longest N` with the longest run of all. Exit status 1 when a run
           of K or more was found.

   Comments and preprocessor lines are left out, and so is `const`. Strings
   and characters are all alike, numbers are compared by value (2 is 2.0).
   Identifiers that are not keywords match whatever they are called, as long
   as the same name on the one side always meets the same name on the other
   within a run: a copy with its variables renamed is still a copy, while
   a - b and a - a are two things. Exit status 2 when a file cannot be read.
 */

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_LENGTH = 64 };

/* A token; `name` counts the identifiers of one program run from 0, and is
   -1 for anything else, whose text then decides. */
struct token {
    char text[NAME_LENGTH];
    int name;
    int line;
};

struct body {
    const char *file;
    char function[NAME_LENGTH];
    struct token *tokens;
    size_t count;
    int line;
};

struct bodies {
    struct body *list;
    size_t count;
};

/* Every identifier seen so far, in order of first appearance. */
static char (*names)[NAME_LENGTH];
static int name_count;

static void *grow(void *memory, size_t bytes)
{
    memory = realloc(memory, bytes ? bytes : 1);
    if (!memory) {
        fprintf(stderr, "tokens: out of memory\n");
        exit(2);
    }
    return memory;
}

static int name_number(const char *text)
{
    for (int i = 0; i < name_count; ++i)
        if (strcmp(names[i], text) == 0)
            return i;
    names = grow(names, ((size_t)name_count + 1) * sizeof names[0]);
    strcpy(names[name_count], text);
    return name_count++;
}

static bool is_keyword(const char *text)
{
    static const char *const keywords[] = {
        "auto",     "break",    "case",   "char",    "continue", "default",
        "do",       "double",   "else",   "enum",    "extern",   "float",
        "for",      "goto",     "if",     "inline",  "int",      "long",
        "register", "restrict", "return", "short",   "signed",   "sizeof",
        "static",   "struct",   "switch", "typedef", "union",    "unsigned",
        "void",     "volatile", "while",  NULL};
    for (const char *const *k = keywords; *k; ++k)
        if (strcmp(*k, text) == 0)
            return true;
    return false;
}

static char *read_file(const char *path)
{
    size_t size = 0, got;
    char *text = NULL;
    FILE *file = fopen(path, "r");
    if (!file) {
        fprintf(stderr, "tokens: cannot read '%s'\n", path);
        exit(2);
    }
    do {
        text = grow(text, size + 65537);
        got = fread(text + size, 1, 65536, file);
        size += got;
    } while (got > 0);
    fclose(file);
    text[size] = '\0';
    return text;
}

/* A place in a text. */
struct reader {
    const char *at;
    int line;
    bool line_start; /* nothing but space since the last newline */
};

static void step(struct reader *r)
{
    if (*r->at == '\n') {
        ++r->line;
        r->line_start = true;
    }
    ++r->at;
}

static void skip_comment(struct reader *r)
{
    const bool block = r->at[1] == '*';
    step(r);
    step(r);
    while (*r->at &&
           (block ? strncmp(r->at, "*/", 2) != 0 : *r->at != '\n'))
        step(r);
    if (block && *r->at) {
        step(r);
        step(r);
    }
}

static bool starts_comment(const struct reader *r)
{
    return *r->at == '/' && (r->at[1] == '*' || r->at[1] == '/');
}

static void skip_directive(struct reader *r)
{
    while (*r->at && *r->at != '\n') {
        if (starts_comment(r)) {
            skip_comment(r);
        } else {
            if (*r->at == '\\' && r->at[1])
                step(r);
            step(r);
        }
    }
}

static void skip_space(struct reader *r)
{
    for (;;) {
        if (isspace((unsigned char)*r->at))
            step(r);
        else if (starts_comment(r))
            skip_comment(r);
        else if (*r->at == '#' && r->line_start)
            skip_directive(r);
        else
            return;
    }
}

static void read_quoted(struct reader *r, struct token *t)
{
    const char quote = *r->at;
    sprintf(t->text, "%c%c", quote, quote);
    step(r);
    while (*r->at && *r->at != quote) {
        if (*r->at == '\\' && r->at[1])
            step(r);
        step(r);
    }
    if (*r->at)
        step(r);
}

static void read_word(struct reader *r, struct token *t)
{
    size_t length = 0;
    while (isalnum((unsigned char)*r->at) || *r->at == '_') {
        if (length + 1 < sizeof t->text)
            t->text[length++] = *r->at;
        step(r);
    }
    t->text[length] = '\0';
    if (!is_keyword(t->text))
        t->name = name_number(t->text);
}

static void read_number(struct reader *r, struct token *t)
{
    char *end;
    snprintf(t->text, sizeof t->text, "%.17g", strtod(r->at, &end));
    while (r->at < end)
        step(r);
    while (isalnum((unsigned char)*r->at)) /* its suffix: 1u, 2.0L */
        step(r);
}

static void read_operator(struct reader *r, struct token *t)
{
    static const char *const operators[] = {
        "<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
        "<=",  ">=",  "==",  "!=", "&&", "||", "+=", "-=",
        "*=",  "/=",  "%=",  "&=", "|=", "^=", NULL};
    size_t length = 1;
    for (const char *const *o = operators; *o; ++o)
        if (strncmp(r->at, *o, strlen(*o)) == 0) {
            length = strlen(*o);
            break;
        }
    snprintf(t->text, sizeof t->text, "%.*s", (int)length, r->at);
    while (length--)
        step(r);
}

/* Reads the next token; false at the end of the text. */
static bool read_token(struct reader *r, struct token *t)
{
    skip_space(r);
    if (!*r->at)
        return false;
    r->line_start = false;
    *t = (struct token){.name = -1, .line = r->line};
    if (*r->at == '"' || *r->at == '\'')
        read_quoted(r, t);
    else if (isalpha((unsigned char)*r->at) || *r->at == '_')
        read_word(r, t);
    else if (isdigit((unsigned char)*r->at) ||
             (*r->at == '.' && isdigit((unsigned char)r->at[1])))
        read_number(r, t);
    else
        read_operator(r, t);
    return true;
}

static bool is(const struct token *t, const char *text)
{
    return t->name < 0 && strcmp(t->text, text) == 0;
}

/* The name of the function whose parameter list ends just before the token
   number `brace`. */
static const char *function_before(const struct token *t, size_t brace)
{
    int depth = 0;
    for (size_t i = brace; i-- > 0;) {
        depth += is(&t[i], ")") - is(&t[i], "(");
        if (depth == 0)
            return i > 0 ? t[i - 1].text : "?";
    }
    return "?";
}

static void add_body(struct bodies *all, const char *file,
                     const struct token *t, size_t brace, size_t end)
{
    struct body b = {.file = file, .line = t[brace].line};
    b.count = end - brace - 1;
    b.tokens = grow(NULL, b.count * sizeof *t);
    memcpy(b.tokens, t + brace + 1, b.count * sizeof *t);
    strcpy(b.function, function_before(t, brace));
    all->list = grow(all->list, (all->count + 1) * sizeof b);
    all->list[all->count++] = b;
}

static void read_bodies(struct bodies *all, const char *file)
{
    char *text = read_file(file);
    struct reader r = {text, 1, true};
    struct token *t = NULL, next;
    size_t count = 0, start = 0;
    int depth = 0;
    while (read_token(&r, &next)) {
        if (strcmp(next.text, "const") == 0)
            continue;
        if ((count & (count + 1)) == 0) /* 0, 1, 3, 7: room is used up */
            t = grow(t, 2 * (count + 1) * sizeof *t);
        t[count++] = next;
        if (is(&next, "{") && depth++ == 0)
            start = count - 1;
        if (is(&next, "}") && --depth == 0 && start > 0 &&
            is(&t[start - 1], ")"))
            add_body(all, file, t, start, count - 1);
    }
    free(t);
    free(text);
}

static void print_bodies(const struct bodies *all)
{
    for (const struct body *b = all->list; b < all->list + all->count;
         ++b) {
        int *number = grow(NULL, (size_t)name_count * sizeof *number);
        int used = 0;
        for (int i = 0; i < name_count; ++i)
            number[i] = 0;
        printf("%s:%d: %s:", b->file, b->line, b->function);
        for (size_t i = 0; i < b->count; ++i) {
            const struct token *t = &b->tokens[i];
            if (t->name < 0) {
                printf(" %s", t->text);
                continue;
            }
            if (!number[t->name])
                number[t->name] = ++used;
            printf(" ID%d", number[t->name]);
        }
        printf("\n");
        free(number);
    }
}

/* The length of the run that starts at a[0] and b[0]. `to` and `from` have
   a place for each name, all of them -1 before and after. */
static size_t run_length(const struct token *a, size_t room_a,
                         const struct token *b, size_t room_b, int *to,
                         int *from)
{
    const size_t room = room_a < room_b ? room_a : room_b;
    size_t n = 0;
    for (; n < room; ++n) {
        const int x = a[n].name, y = b[n].name;
        if (x < 0 || y < 0) {
            if (x != y || strcmp(a[n].text, b[n].text) != 0)
                break;
        } else if (to[x] < 0 && from[y] < 0) {
            to[x] = y;
            from[y] = x;
        } else if (to[x] != y) {
            break;
        }
    }
    for (size_t i = 0; i < n; ++i)
        if (a[i].name >= 0)
            to[a[i].name] = from[b[i].name] = -1;
    return n;
}

/* The longest run that the two bodies share; *at is where it starts in a.
 */
static size_t longest_run(const struct body *a, const struct body *b,
                          size_t *at, int *to, int *from)
{
    size_t longest = 0;
    for (size_t i = 0; i + longest < a->count; ++i)
        for (size_t j = 0; j + longest < b->count; ++j) {
            const size_t n =
                run_length(a->tokens + i, a->count - i, b->tokens + j,
                           b->count - j, to, from);
            if (n > longest) {
                longest = n;
                *at = i;
            }
        }
    return longest;
}

static bool compare(const struct bodies *own, const struct bodies *book,
                    size_t limit)
{
    int *to = grow(NULL, (size_t)name_count * sizeof *to);
    int *from = grow(NULL, (size_t)name_count * sizeof *from);
    size_t longest = 0;
    for (int i = 0; i < name_count; ++i)
        to[i] = from[i] = -1;
    for (size_t i = 0; i < own->count; ++i)
        for (size_t j = 0; j < book->count; ++j) {
            const struct body *a = &own->list[i], *b = &book->list[j];
            size_t at = 0;
            const size_t n = longest_run(a, b, &at, to, from);
            if (n > longest)
                longest = n;
            if (n < limit)
                continue;
            printf("%s:%d: %s shares %zu tokens with %s in %s:%d:", a->file,
                   a->tokens[at].line, a->function, n, b->function, b->file,
                   b->line);
            for (size_t k = at; k < at + n; ++k)
                printf(" %s", a->tokens[k].text);
            printf("\n");
        }
    printf("longest %zu\n", longest);
    free(to);
    free(from);
    return longest >= limit;
}

int main(int argc, char **argv)
{
    struct bodies own = {NULL, 0}, book = {NULL, 0};
    struct bodies *into = &own;
    const bool shared = argc > 2 && strcmp(argv[1], "--shared") == 0;
    const int limit = shared ? atoi(argv[2]) : 0;
    for (int i = shared ? 3 : 1; i < argc; ++i) {
        if (shared && strcmp(argv[i], "--") == 0)
            into = &book;
        else
            read_bodies(into, argv[i]);
    }
    if (own.count == 0 || (shared && (limit < 1 || book.count == 0))) {
        fprintf(stderr,
                "usage: tokens FILE... or tokens --shared K FILE... "
                "-- BOOK...\n"
                "tokens: no function bodies to compare\n");
        return 2;
    }
    if (shared)
        return compare(&own, &book, (size_t)limit) ? 1 : 0;
    print_bodies(&own);
    return 0;
}
