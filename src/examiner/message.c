/* Explains compiler messages, using a table of their usual meanings. */
#include "examiner/message.h"
#include "examiner/text.h"

#include <stddef.h>
#include <string.h>

/* One row for each mistake, with words from the messages of gcc and clang.
   The first matching row is used, so special cases come before general
   ones. In an explanation, NAME stands for the first name that the message
   quotes. A row without an explanation is for a name that the compiler does
   not know. There is no row for a message whose meaning could only be
   guessed: students believe a wrong explanation, which costs more than a
   missing one. */
static const struct meaning {
    const char *gcc, *clang; /* words in messages; clang NULL: as gcc */
    const char *text;
} meanings[] = {
    {"expected ';'", "expected ',' or ';'",
     "A statement ends with a semicolon, and one is missing: here, or at "
     "the end of the line above."},
    {"expected '=', ',', ';'", NULL,
     "The compiler lost its way here. Is a word misspelt, or a semicolon "
     "missing above?"},
    {"expected ')'", NULL,
     "A parenthesis is missing, here or in the line above: count ( and )."},
    {"stray '", "unexpected character",
     "Here is a character that C does not know, perhaps a minus sign or a "
     "quotation mark copied from a page. Type it anew."},
    {"'else' without", NULL,
     "An else follows its if directly. Is there a semicolon behind the if, "
     "or are braces missing?"},
    {"expected expression", NULL,
     "Something is missing here: a number, a name or a formula."},
    {"at end of input", "expected '}'",
     "A brace } is missing: a { somewhere above was never closed."},
    {"function definition is not allowed", NULL,
     "A function begins inside another one. Is a } missing above?"},
    {"expected identifier or '('", "extraneous closing brace",
     "This stands outside of every function. Is there a } too many above?"},
    {"undeclared", "unknown type name", NULL},
    {"implicit declaration", "implicitly declaring", NULL},
    {"No such file or directory", "file not found",
     "There is no header of this name. The kit has \"exercise.h\"; those "
     "of the C library stand in < and >."},
    {"has no member named", "no member named",
     "The structure has no such member. Its declaration stands at the top "
     "of the file."},
    {"redefinition of", "redeclared as",
     "NAME is there twice. One of the two has to go, or needs another "
     "name."},
    {"conflicting types for", NULL,
     "NAME is declared in two ways that do not agree. Compare the two "
     "lines."},
    {"pointer from integer", "integer to pointer",
     "A number stands where an array or a pointer is expected."},
    {"integer from pointer", "pointer to integer",
     "An array or a pointer stands where a number is expected. Is an index "
     "missing, or a *?"},
    {"did you mean to use '->'", NULL,
     "Behind a pointer a member is written with an arrow: p->x and not "
     "p.x."},
    {"not a structure or union", NULL,
     "Only a structure has members, and this is none."},
    {"subscripted value", "array subscript is not an integer",
     "Only an array has elements, x[i], and i must be a whole number."},
    {"incompatible", "invalid initializer",
     "The types do not fit. Is one of the two an array, a pointer or a "
     "structure, and the other a number?"},
    {"too few arguments", NULL,
     "The call has fewer values than the function takes. Compare it with "
     "the function's first line."},
    {"too many arguments", NULL,
     "The call has more values than the function takes. Compare it with "
     "the function's first line."},
    {"called object", NULL,
     "A parenthesis behind a number or a variable calls it, as if it were "
     "a function. Is a * missing in front of it?"},
    {"operands to binary ^", "operands to binary %",
     "The signs ^ and % are for whole numbers. A square is x * x, a power "
     "pow(x, y), a remainder fmod(x, y)."},
    {"operands to binary expression ('double' and 'int')",
     "operands to binary expression ('double' and 'double')",
     "The signs ^ and % are for whole numbers. A square is x * x, a power "
     "pow(x, y), a remainder fmod(x, y)."},
    {"operands to binary", NULL,
     "These two cannot be combined. Is one of them an array, a pointer or "
     "a structure?"},
    {"read-only", "const-qualified",
     "This is const: it is given, and must not be changed."},
    {"lvalue required", "expression is not assignable",
     "On the left of = must stand something that can be changed, and this "
     "is a formula."},
    /* C lets a function end without a return. The caller then gets whatever
       is in a register, perhaps the right number. One wrong answer in the
       kit's tests passed that way, because clang assumed that the path
       without a return is never taken. So the makefile turns this warning
       into an error. It does the same with two warnings that newer
       compilers treat as errors anyway. */
    {"reaches end of non-void", "void function does not return a value",
     "There is a way through the function on which it ends without a "
     "return. What is its value then?"},
    {"'return' with a value", "should not return a value",
     "The function is void: it returns nothing. Where does its result "
     "belong?"},
    {"'return' with no value", "should return a value",
     "The function promises a value, and this return has none."},
    {"expects argument of type", "format specifies type",
     "printf is told of another type than it gets: %g is for double, %d "
     "for int, %zu for size_t."},
    {"assignment used as truth", "assignment as a condition",
     "A single = assigns; == compares. Which of them is meant?"},
    {"statement with no effect", "result unused",
     "This line computes something and throws it away. Is an = or a return "
     "missing?"},
    {"value computed is not used", NULL,
     "This line computes something and throws it away. Is an = or a return "
     "missing?"},
    /* The remaining rows explain warnings. A warning is shown only if a
       test has failed: it is then the likeliest reason. */
    {"uninitialized", NULL,
     "NAME has no value yet when it is used. What should it begin with?"},
    {"integer absolute value", NULL,
     "abs is for whole numbers; for double it is fabs, of <math.h>."},
    {"mathematical meaning", "boolean expression is always",
     "a < b < c is not what it is on paper. Write a < b && b < c."},
    {"empty body", NULL,
     "The semicolon behind the parenthesis is all that is done here; what "
     "follows is no part of it."},
    {"does not guard", "misleading indentation",
     "Only the first statement belongs to it. Braces hold several "
     "together."}};

static const struct {
    const char *header, *names; /* names with a blank on either side */
} headers[] = {
    {"math.h", " sqrt fabs pow sin cos tan asin acos atan atan2 exp log "
               "log10 hypot cbrt floor ceil round fmin fmax fmod isnan "
               "isinf isfinite NAN INFINITY HUGE_VAL M_PI "},
    {"stdlib.h", " malloc calloc realloc free abs qsort exit abort rand "},
    {"stdbool.h", " bool true false "},
    {"stddef.h", " size_t NULL "},
    {"float.h", " DBL_EPSILON DBL_MAX DBL_MIN "},
    {"stdio.h", " printf puts putchar fprintf snprintf stderr stdout "},
    {"string.h", " memcpy memmove memset strlen strcmp "},
    {"stdint.h", " uint64_t int64_t uint32_t int32_t "},
    {"limits.h", " INT_MAX INT_MIN "},
    {"assert.h", " assert "}};

enum { LINE_ROOM = 512 };

/* Copies a line without its newline and returns the matching row of the
   table `meanings`, or NULL. */
static const struct meaning *meaning_of(char copy[LINE_ROOM],
                                        const char *line)
{
    const struct meaning *m = meanings;
    snprintf(copy, LINE_ROOM, "%.*s", (int)strcspn(line, "\n"), line);
    for (; m < meanings + sizeof meanings / sizeof *meanings; ++m)
        if (strstr(copy, m->gcc) || (m->clang && strstr(copy, m->clang)))
            return m;
    return NULL;
}

bool message_known(const char *line)
{
    char copy[LINE_ROOM];
    return meaning_of(copy, line) != NULL;
}

void message_quoted(char name[MESSAGE_NAME], const char *from)
{
    const char *mark = from ? strchr(from, '\'') : NULL;
    const size_t length = mark ? strcspn(mark + 1, "'") : 0;
    snprintf(name, MESSAGE_NAME, "%.*s", (int)length, mark ? mark + 1 : "");
}

/* Returns the header that declares a name. Each name is compared with a
   blank on either side, so that exp is not found in expm1. */
static const char *header_of(const char *name)
{
    char word[MESSAGE_NAME + 2];
    snprintf(word, sizeof word, " %s ", name);
    for (size_t i = 0; *name && i < sizeof headers / sizeof *headers; ++i)
        if (strstr(headers[i].names, word))
            return headers[i].header;
    return NULL;
}

/* Explains an unknown name. If a header declares the name, proposes that
   header and not the name that the compiler suggests: for NAN without
   <math.h>, a compiler may suggest any other name of three letters. */
static void explain_stranger(FILE *story, const char *line)
{
    char name[MESSAGE_NAME], meant[MESSAGE_NAME], text[LINE_ROOM];
    message_quoted(name, line);
    message_quoted(meant, strstr(line, "did you mean '"));
    const char *header = header_of(name);
    if (header)
        snprintf(text, sizeof text,
                 "%s comes with <%s>. Is #include <%s> at the top of the "
                 "file?",
                 name, header, header);
    else if (*meant)
        snprintf(text, sizeof text, "%s is not known here. Is %s meant?",
                 name, meant);
    else
        snprintf(text, sizeof text,
                 "%s is not known here. Is it spelt right, and declared "
                 "above this line?",
                 name);
    text_field(story, "means", text);
}

/* Writes the sentence `text`, replacing NAME with the first name that
   `line` quotes. The table does not use %s, because compilers cannot check
   formats from a table. */
static void explain_known(FILE *story, const char *text, const char *line)
{
    char name[MESSAGE_NAME], sentence[LINE_ROOM];
    const char *place = strstr(text, "NAME");
    message_quoted(name, line);
    if (place)
        snprintf(sentence, sizeof sentence, "%.*s%s%s", (int)(place - text),
                 text, name, place + strlen("NAME"));
    text_field(story, "means", place ? sentence : text);
}

void message_explain(FILE *story, const char *line)
{
    char copy[LINE_ROOM];
    const struct meaning *meaning = meaning_of(copy, line);
    if (meaning && meaning->text)
        explain_known(story, meaning->text, copy);
    else if (meaning)
        explain_stranger(story, copy);
}
