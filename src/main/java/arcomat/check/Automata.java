package arcomat.check;

import arcomat.source.Span;
import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ComponentSymbol;
import arcomat.tree.Automaton;
import arcomat.tree.Node;

/** How messages point at an automaton and name it. */
final class Automata {
    private static final String KEYWORD = "automaton";

    private Automata() {}

    /** The name; where there is none the keyword; in bodies without a keyword the first line. */
    static Span head(AutomatonSymbol automaton) {
        Automaton node = automaton.node();
        return node.name().map(Node::span).orElseGet(() -> headWithoutName(node));
    }

    /** "automaton 'Name'" or "the automaton". */
    static String subject(AutomatonSymbol automaton) {
        return automaton.name().isEmpty()
                ? "the automaton"
                : "automaton '" + automaton.name() + "'";
    }

    /** Whether analyses look at it without being told with which arguments. */
    static boolean isExamined(AutomatonSymbol automaton) {
        return automaton.component().map(Automata::isExamined).orElse(true);
    }

    private static boolean isExamined(ComponentSymbol component) {
        return !component.isPlatform()
                && !component.isGeneric()
                && component.enclosing().map(Automata::isPlain).orElse(true)
                && component.parameters().stream().allMatch(each -> each.initial().isPresent());
    }

    private static boolean isPlain(ComponentSymbol component) {
        return !component.isGeneric() && component.enclosing().map(Automata::isPlain).orElse(true);
    }

    private static Span headWithoutName(Automaton automaton) {
        Span whole = automaton.span();
        int start = whole.start();
        for (Node stereotype : automaton.stereotypes()) {
            start = Math.max(start, stereotype.span().end());
        }
        String text = whole.file().text();
        int keyword = text.indexOf(KEYWORD, start);
        boolean isHead =
                keyword >= 0
                        && keyword < whole.end()
                        && text.substring(start, keyword).chars().noneMatch(c -> c == '{');
        return isHead
                ? whole.file().span(keyword, keyword + KEYWORD.length())
                : whole.file().span(start, firstLineEnd(text, start, whole.end()));
    }

    private static int firstLineEnd(String text, int start, int end) {
        int at = start;
        while (at < end && text.charAt(at) != '\n' && text.charAt(at) != '\r') {
            at++;
        }
        return at;
    }
}
