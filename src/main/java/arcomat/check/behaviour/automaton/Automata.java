package arcomat.check.behaviour.automaton;

import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
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
        ComponentSymbol component = automaton.component().orElse(null);
        if (component == null) {
            return true;
        }
        for (ParameterSymbol each : component.parameters()) {
            if (each.initial().isEmpty()) {
                return false;
            }
        }
        return !component.isPlatform() && isPlain(component);
    }

    private static boolean isPlain(ComponentSymbol component) {
        ComponentSymbol around = component.enclosing().orElse(null);
        return !component.signature().isGeneric() && (around == null || isPlain(around));
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
