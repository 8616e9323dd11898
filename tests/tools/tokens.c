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

       tokens --within K FILE... -- TEXT...
           looks for each function body of K tokens or more of the files
           before the --, whole, in each of the texts after it, which need
           not be C, and prints for each that it finds a line
           FILE:LINE: NAME<tab>TEXT:LINE
           and then one line `N bodies sought, the longest left out has N
           tokens`. A text is read twice: as C, and once more with all that
           stands in its comments, strings and preprocessor lines taken for
           code. Exit status 1 when a body was found.

   Comments and preprocessor lines are left out, and so is `const`. Strings
   and characters are all alike, numbers are compared by value (2 is 2.0).
   Identifiers that are not keywords match whatever they are called, as long
   as the same name on the one side always meets the same name on the other
   within a run: a copy with its variables renamed is still a copy, while
   a - b and a - a are two things. Exit status 2 when a file cannot be read.
 */

#define PROGRAM "tokens"
#include "source.h"

#include <stdint.h>

enum { NAME_LENGTH = 64 };

/* A token; `name` counts the identifiers of one program run from 0, and is
   -1 for anything else. */
struct token {
    char text[NAME_LENGTH];
    int name;
    int line;
    const char *at; /* in its text */
};

/* A token's kind is the number of its text, or -1 for an identifier, which
   any other may match: tokens match only where their kinds are equal. */
struct tokens {
    struct token *list;
    int *kinds;
    size_t count;
};

/* `opened` are the tokens with the strings opened. */
struct body {
    const char *file;
    char function[NAME_LENGTH];
    struct tokens code, opened;
    int line;
};

struct bodies {
    struct body *list;
    size_t count;
};

/* How a text is read: as C, with its strings opened, or with its comments
   and preprocessor lines opened as well. */
enum reading { AS_CODE, OPEN_STRINGS, OPEN_ALL };

/* Every identifier seen so far, in order of first appearance, and where to
   find it: `places` has a power of two of places, each with the number of a
   name or -1. */
static char (*names)[NAME_LENGTH];
static int name_count;
static int *places;
static size_t place_count;

/* Where the name stands in `places`, or should. */
static size_t place_of(const char *text)
{
    size_t place = 5381;
    for (const char *c = text; *c; ++c)
        place = place * 33 + (unsigned char)*c;
    place &= place_count - 1;
    while (places[place] >= 0 && strcmp(names[places[place]], text) != 0)
        place = (place + 1) & (place_count - 1);
    return place;
}

static void make_room(void)
{
    place_count = place_count ? 2 * place_count : 1024;
    places = grow(places, place_count * sizeof *places);
    names = grow(names, place_count * sizeof *names);
    for (size_t i = 0; i < place_count; ++i)
        places[i] = -1;
    for (int i = 0; i < name_count; ++i)
        places[place_of(names[i])] = i;
}

static int name_number(const char *text)
{
    if (2 * (size_t)name_count >= place_count)
        make_room();
    const size_t place = place_of(text);
    if (places[place] < 0) {
        strcpy(names[name_count], text);
        places[place] = name_count++;
    }
    return places[place];
}

static bool is_keyword(const char *text)
{
    static const char keywords[] =
        " auto break case char continue default do double else enum extern "
        "float for goto if inline int long register restrict return short "
        "signed sizeof static struct switch typedef union unsigned void "
        "volatile while ";
    char spaced[NAME_LENGTH + 2];
    snprintf(spaced, sizeof spaced, " %s ", text);
    return strstr(keywords, spaced) != NULL;
}

/* A place in a text. */
struct reader {
    const char *at, *end;
    enum reading reading;
    int line;
    bool line_start; /* nothing but space since the last newline */
};

static void go(struct reader *r, const char *to)
{
    for (; r->at < to; ++r->at)
        if (*r->at == '\n') {
            ++r->line;
            r->line_start = true;
        }
}

/* How many characters here are no code but a mark around it. */
static int mark_length(const struct reader *r)
{
    const char *at = r->at;
    if (r->reading == AS_CODE)
        return 0;
    if (*at == '\\')
        return at[1] == 'n' || at[1] == 't' ? 2 : 1;
    if (*at == '"' || *at == '\'')
        return 1;
    if (r->reading == OPEN_STRINGS)
        return 0;
    if (is_comment(at) || (*at == '*' && at[1] == '/'))
        return 2;
    if (r->line_start && (*at == '#' || *at == '%'))
        return 1;
    return r->line_start && *at == '*' && isspace((unsigned char)at[1]);
}

static void skip_space(struct reader *r)
{
    while (r->at < r->end) {
        const int marks = mark_length(r);
        if (marks || isspace((unsigned char)*r->at))
            go(r, r->at + (marks ? marks : 1));
        else if (is_comment(r->at))
            go(r, after_comment(r->at));
        else if (*r->at == '#' && r->line_start)
            go(r, after_directive(r->at));
        else
            return;
    }
}

static void read_word(struct reader *r, struct token *t)
{
    const char *end = after_word(r->at);
    snprintf(t->text, sizeof t->text, "%.*s", (int)(end - r->at), r->at);
    go(r, end);
    if (!is_keyword(t->text))
        t->name = name_number(t->text);
}

static void read_number(struct reader *r, struct token *t)
{
    char *end;
    snprintf(t->text, sizeof t->text, "%.17g", strtod(r->at, &end));
    while (isalnum((unsigned char)*end)) /* its suffix: 1u, 2.0L */
        ++end;
    go(r, end);
}

/* Reads the next token; false at the end of the text. */
static bool read_token(struct reader *r, struct token *t)
{
    skip_space(r);
    if (r->at >= r->end)
        return false;
    r->line_start = false;
    *t = (struct token){.name = -1, .line = r->line, .at = r->at};
    if (starts_word(r->at)) {
        read_word(r, t);
    } else if (starts_number(r->at)) {
        read_number(r, t);
    } else if (*r->at == '"' || *r->at == '\'') {
        sprintf(t->text, "%c%c", *r->at, *r->at);
        go(r, after_quoted(r->at));
    } else {
        go(r, after_punctuation(r->at));
        snprintf(t->text, sizeof t->text, "%.*s", (int)(r->at - t->at),
                 t->at);
    }
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

static int kind_of(const struct token *t)
{
    return t->name < 0 ? name_number(t->text) : -1;
}

static struct tokens with_kinds(struct token *list, size_t count)
{
    struct tokens t = {list, grow(NULL, count * sizeof *t.kinds), count};
    for (size_t i = 0; i < count; ++i)
        t.kinds[i] = kind_of(&list[i]);
    return t;
}

static void free_tokens(struct tokens *t)
{
    free(t->list);
    free(t->kinds);
}

/* The tokens from `text` up to `end`. */
static struct tokens read_tokens(const char *text, const char *end,
                                 enum reading reading)
{
    struct reader r = {text, end, reading, 1, true};
    struct token *t = NULL, next;
    size_t count = 0;
    while (read_token(&r, &next)) {
        if (strcmp(next.text, "const") == 0)
            continue;
        if ((count & (count + 1)) == 0) /* 0, 1, 3, 7: room is used up */
            t = grow(t, 2 * (count + 1) * sizeof *t);
        t[count++] = next;
    }
    return with_kinds(t, count);
}

static void add_body(struct bodies *all, const char *file,
                     const struct token *t, size_t brace, size_t end)
{
    struct body b = {.file = file, .line = t[brace].line};
    const size_t count = end - brace - 1;
    struct token *code = grow(NULL, count * sizeof *t);
    memcpy(code, t + brace + 1, count * sizeof *t);
    b.code = with_kinds(code, count);
    b.opened = read_tokens(t[brace].at + 1, t[end].at, OPEN_STRINGS);
    strcpy(b.function, function_before(t, brace));
    all->list = grow(all->list, (all->count + 1) * sizeof b);
    all->list[all->count++] = b;
}

static void read_bodies(struct bodies *all, const char *file)
{
    size_t length, start = 0;
    char *text = read_file(file, &length);
    struct tokens read = read_tokens(text, text + length, AS_CODE);
    const struct token *t = read.list;
    int depth = 0;
    for (size_t i = 0; i < read.count; ++i) {
        if (is(&t[i], "{") && depth++ == 0)
            start = i;
        if (is(&t[i], "}") && --depth == 0 && start > 0 &&
            is(&t[start - 1], ")"))
            add_body(all, file, t, start, i);
    }
    free_tokens(&read);
    free(text);
}

static void print_bodies(const struct bodies *all)
{
    const size_t room = (size_t)name_count * sizeof(int);
    int *number = grow(NULL, room);
    for (const struct body *b = all->list; b < all->list + all->count;
         ++b) {
        int used = 0;
        memset(number, 0, room);
        printf("%s:%d: %s:", b->file, b->line, b->function);
        for (size_t i = 0; i < b->code.count; ++i) {
            const struct token *t = &b->code.list[i];
            if (t->name < 0) {
                printf(" %s", t->text);
                continue;
            }
            if (!number[t->name])
                number[t->name] = ++used;
            printf(" ID%d", number[t->name]);
        }
        printf("\n");
    }
}

/* The name that each name is taken for within a run, and the other way
   round: -1 before and after. */
static int *to, *from;
static void forget_names(void)
{
    to = grow(to, (size_t)name_count * sizeof *to);
    from = grow(from, (size_t)name_count * sizeof *from);
    for (int i = 0; i < name_count; ++i)
        to[i] = from[i] = -1;
}

/* The length of the run that starts at a[i] and b[j], at most `room`. */
static size_t run_length(const struct tokens *a, size_t i,
                         const struct tokens *b, size_t j, size_t room)
{
    size_t n = 0;
    for (; n < room && a->kinds[i + n] == b->kinds[j + n]; ++n) {
        const int x = a->list[i + n].name, y = b->list[j + n].name;
        if (x < 0)
            continue;
        if (to[x] < 0 && from[y] < 0) {
            to[x] = y;
            from[y] = x;
        } else if (to[x] != y) {
            break;
        }
    }
    for (size_t k = 0; k < n; ++k)
        if (a->list[i + k].name >= 0)
            to[a->list[i + k].name] = from[b->list[j + k].name] = -1;
    return n;
}

/* Where the kinds of eight tokens in a row are noted. A run of eight that
   two bodies share stands in the sieves of both. */
enum { ROW = 8, SIEVE = 8192 };

static size_t sieve_place(const int *kinds)
{
    uint64_t sum = 0;
    for (int k = 0; k < ROW; ++k)
        sum = (sum ^ (uint64_t)(kinds[k] + 1)) * UINT64_C(1099511628211);
    return (sum ^ sum >> 29) % SIEVE;
}

static void fill_sieve(bool sieve[SIEVE], const struct tokens *t)
{
    memset(sieve, 0, SIEVE * sizeof *sieve);
    for (size_t i = 0; i + ROW <= t->count; ++i)
        sieve[sieve_place(t->kinds + i)] = true;
}

/* The longest run of more than `floor` tokens that the two share, `floor`
   if there is none; *at is where it starts in a. A run that is longer than
   the longest so far stands in the sieve of b and has equal kinds where
   that one ended: that is asked first. `places` are those of a. */
static size_t longest_run(const struct tokens *a, const size_t *places,
                          const struct tokens *b, const bool sieve[SIEVE],
                          size_t floor, size_t *at)
{
    size_t longest = floor;
    for (size_t i = 0; i + longest < a->count; ++i)
        for (size_t j = longest < ROW || sieve[places[i]] ? 0 : b->count;
             j + longest < b->count; ++j) {
            if (a->kinds[i + longest] != b->kinds[j + longest] ||
                a->kinds[i] != b->kinds[j])
                continue;
            const size_t room_a = a->count - i, room_b = b->count - j;
            const size_t n =
                run_length(a, i, b, j, room_a < room_b ? room_a : room_b);
            if (n > longest) {
                longest = n;
                *at = i;
                if (i + longest >= a->count)
                    break;
            }
        }
    return longest;
}

/* For each body where its rows stand in a sieve. */
static size_t **all_places(const struct bodies *all)
{
    size_t **places = grow(NULL, all->count * sizeof *places);
    for (size_t i = 0; i < all->count; ++i) {
        const struct tokens *t = &all->list[i].code;
        places[i] = grow(NULL, t->count * sizeof **places);
        for (size_t k = 0; k + ROW <= t->count; ++k)
            places[i][k] = sieve_place(t->kinds + k);
    }
    return places;
}

static bool compare(const struct bodies *own, const struct bodies *book,
                    size_t limit)
{
    size_t longest = 0, **places = all_places(own);
    forget_names();
    for (size_t j = 0; j < book->count; ++j) {
        bool sieve[SIEVE];
        fill_sieve(sieve, &book->list[j].code);
        for (size_t i = 0; i < own->count; ++i) {
            const struct body *a = &own->list[i], *b = &book->list[j];
            size_t at = 0;
            const size_t floor = longest < limit ? longest : limit - 1;
            const size_t n = longest_run(&a->code, places[i], &b->code,
                                         sieve, floor, &at);
            if (n > longest)
                longest = n;
            if (n < limit)
                continue;
            printf("%s:%d: %s shares %zu tokens with %s in %s:%d:", a->file,
                   a->code.list[at].line, a->function, n, b->function,
                   b->file, b->line);
            for (size_t k = at; k < at + n; ++k)
                printf(" %s", a->code.list[k].text);
            printf("\n");
        }
    }
    printf("longest %zu\n", longest);
    return longest >= limit;
}

/* A text to search: where each kind of token stands in it, the places of
   the kind k from first[k] up to first[k + 1]. Kinds that came up after it
   was read have none. */
struct text {
    struct tokens tokens;
    size_t *places, *first;
    int kinds;
};

static struct text read_text(const char *from, const char *end,
                             enum reading reading)
{
    struct text t = {.tokens = read_tokens(from, end, reading)};
    t.kinds = name_count;
    t.places = grow(NULL, t.tokens.count * sizeof *t.places);
    t.first = grow(NULL, ((size_t)t.kinds + 2) * sizeof *t.first);
    for (int k = 0; k < t.kinds + 2; ++k)
        t.first[k] = 0;
    for (size_t i = 0; i < t.tokens.count; ++i)
        if (t.tokens.kinds[i] >= 0)
            ++t.first[t.tokens.kinds[i] + 2];
    for (int k = 0; k < t.kinds; ++k)
        t.first[k + 2] += t.first[k + 1];
    for (size_t i = 0; i < t.tokens.count; ++i)
        if (t.tokens.kinds[i] >= 0)
            t.places[t.first[t.tokens.kinds[i] + 1]++] = i;
    return t;
}

static void free_text(struct text *t)
{
    free_tokens(&t->tokens);
    free(t->places);
    free(t->first);
}

static size_t times(const struct text *text, int kind)
{
    return kind < text->kinds ? text->first[kind + 1] - text->first[kind]
                              : 0;
}

/* Looks for the tokens, whole, in the text; the line where they begin, or
   0. Only where the rarest of them stands need the others be tried. */
static int find_tokens(const struct tokens *sought, const struct text *text)
{
    const size_t none = sought->count;
    size_t rare = none;
    for (size_t i = 0; i < sought->count; ++i)
        if (sought->kinds[i] >= 0 &&
            (rare == none || times(text, sought->kinds[i]) <
                                 times(text, sought->kinds[rare])))
            rare = i;
    if (rare == none || times(text, sought->kinds[rare]) == 0)
        return 0;
    const int kind = sought->kinds[rare];
    for (size_t k = text->first[kind]; k < text->first[kind + 1]; ++k) {
        const size_t place = text->places[k];
        if (place >= rare &&
            place - rare + sought->count <= text->tokens.count &&
            run_length(sought, 0, &text->tokens, place - rare,
                       sought->count) == sought->count)
            return text->tokens.list[place - rare].line;
    }
    return 0;
}

/* Looks for the bodies in one text; returns whether one was found. */
static bool search(const struct bodies *own, size_t limit, const char *path)
{
    size_t length;
    char *text = read_file(path, &length);
    struct text code = read_text(text, text + length, AS_CODE);
    struct text all = read_text(text, text + length, OPEN_ALL);
    bool found = false;
    forget_names();
    for (size_t i = 0; i < own->count; ++i) {
        const struct body *b = &own->list[i];
        if (b->code.count < limit)
            continue;
        int line = find_tokens(&b->code, &code);
        if (!line)
            line = find_tokens(&b->opened, &all);
        if (line)
            printf("%s:%d: %s\t%s:%d\n", b->file, b->line, b->function,
                   path, line);
        found |= line != 0;
    }
    free_text(&code);
    free_text(&all);
    free(text);
    return found;
}

static void count_sought(const struct bodies *own, size_t limit)
{
    size_t sought = 0, longest = 0;
    for (size_t i = 0; i < own->count; ++i)
        if (own->list[i].code.count >= limit)
            ++sought;
        else if (own->list[i].code.count > longest)
            longest = own->list[i].code.count;
    printf("%zu bodies sought, the longest left out has %zu tokens\n",
           sought, longest);
}

int main(int argc, char **argv)
{
    struct bodies own = {NULL, 0}, book = {NULL, 0};
    const bool shared = argc > 2 && strcmp(argv[1], "--shared") == 0;
    const bool within = argc > 2 && strcmp(argv[1], "--within") == 0;
    const bool paired = shared || within;
    const int limit = paired ? atoi(argv[2]) : 0;
    int i = paired ? 3 : 1;
    bool found = false;
    for (; i < argc && (!paired || strcmp(argv[i], "--") != 0); ++i)
        read_bodies(&own, argv[i]);
    const int texts = argc - ++i;
    for (; shared && i < argc; ++i)
        read_bodies(&book, argv[i]);
    if (own.count == 0 || (paired && limit < 1) ||
        (shared && book.count == 0) || (within && texts < 1)) {
        fprintf(stderr,
                "usage: tokens FILE... or tokens --shared K FILE... "
                "-- BOOK... or tokens --within K FILE... -- TEXT...\n"
                "tokens: no function bodies to compare\n");
        return 2;
    }
    if (shared)
        return compare(&own, &book, (size_t)limit) ? 1 : 0;
    for (; within && i < argc; ++i)
        found |= search(&own, (size_t)limit, argv[i]);
    if (within)
        count_sought(&own, (size_t)limit);
    else
        print_bodies(&own);
    return found ? 1 : 0;
}
