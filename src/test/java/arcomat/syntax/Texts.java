package arcomat.syntax;

import arcomat.source.SourceFile;

/** Short texts for tests. */
final class Texts {
    private Texts() {}

    static SourceFile component(String body) {
        return new SourceFile("A.arc", "component A {\n" + body + "\n}\n");
    }

    /** Two automaton elements with the expression in a guard and in items. */
    static SourceFile expression(String expression) {
        return component(
                "automaton { a -> b [%s]; c {x == %s} / {y = %s}; }"
                        .formatted(expression, expression, expression));
    }
}
