package arcomat.diagram;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** What stands beside the arrow of a transition: guard and input block above, outputs below. */
final class TransitionText {
    /** A longer line is broken after an item. */
    private static final int LONG = 44;

    /** An item that is longer still is cut; the tooltip has all of it. */
    private static final int LONGEST = 72;

    private TransitionText() {}

    static List<Graph.Line> label(Automaton.Transition transition) {
        List<String> lines = new ArrayList<>();
        if (transition.rank() > 0) {
            lines.add(behind(transition));
        }
        lines.addAll(guard(transition.guard()));
        lines.addAll(block("", inputs(transition)));
        lines.addAll(block("/ ", outputs(transition.sends(), transition.assignments())));
        return small(lines);
    }

    static List<Graph.Line> label(Automaton.Initial initial) {
        return small(block("/ ", outputs(initial.sends(), initial.assignments())));
    }

    private static List<Graph.Line> small(List<String> lines) {
        return lines.stream().map(TransitionText::cut).map(Graph.Line::small).toList();
    }

    /** In one line and in full. */
    static String full(Automaton.Transition transition) {
        StringBuilder text = new StringBuilder();
        if (transition.rank() > 0) {
            text.append(behind(transition)).append(' ');
        }
        transition.guard().ifPresent(guard -> text.append("[" + ExpressionText.of(guard) + "] "));
        if (!transition.matches().isEmpty()) {
            text.append("{" + String.join(", ", inputs(transition)) + "} ");
        }
        List<String> outputs = outputs(transition.sends(), transition.assignments());
        if (!outputs.isEmpty()) {
            text.append("/ {" + String.join(", ", outputs) + "}");
        }
        return text.toString().strip();
    }

    /** That transitions with smaller numbers come first, those without one before all. */
    private static String behind(Automaton.Transition transition) {
        return transition.rank() + ".";
    }

    private static List<String> guard(Optional<Expression> guard) {
        if (guard.isEmpty()) {
            return List.of();
        }
        String text = "[" + ExpressionText.of(guard.get()) + "]";
        if (text.length() <= LONG) {
            return List.of(text);
        }
        return broken(text.replace(" && ", " &&\n").replace(" || ", " ||\n").split("\n"));
    }

    private static List<String> inputs(Automaton.Transition transition) {
        return transition.matches().stream()
                .map(match -> ExpressionText.item(match.port().name(), match.pattern()))
                .toList();
    }

    private static List<String> outputs(
            List<Automaton.Send> sends, List<Automaton.Assignment> assignments) {
        List<String> outputs = new ArrayList<>();
        sends.forEach(send -> outputs.add(send.port().name() + " = " + emission(send.emission())));
        assignments.forEach(
                each ->
                        outputs.add(
                                each.variable().name() + " = " + ExpressionText.of(each.value())));
        return outputs;
    }

    private static String emission(Automaton.Emission emission) {
        return emission.match(messages -> list(messages.values()), () -> "--", () -> "?");
    }

    private static String list(List<Expression> values) {
        String all = values.stream().map(ExpressionText::of).collect(Collectors.joining(", "));
        return values.size() == 1 ? all : "[" + all + "]";
    }

    /** Items side by side, as many as fit on a line. */
    private static List<String> block(String before, List<String> items) {
        if (items.isEmpty()) {
            return List.of();
        }
        String[] separated = new String[items.size()];
        for (int i = 0; i < separated.length; i++) {
            separated[i] = items.get(i) + (i + 1 < separated.length ? ", " : "");
        }
        List<String> lines = broken(separated);
        lines.set(0, before + lines.get(0));
        return lines;
    }

    private static List<String> broken(String[] pieces) {
        List<String> lines = new ArrayList<>();
        for (String piece : pieces) {
            int last = lines.size() - 1;
            if (last >= 0 && lines.get(last).length() + piece.length() <= LONG) {
                lines.set(last, lines.get(last) + separator(lines.get(last)) + piece);
            } else {
                lines.add(piece);
            }
        }
        lines.replaceAll(String::strip);
        return lines;
    }

    private static String separator(String line) {
        return line.endsWith(" ") ? "" : " ";
    }

    private static String cut(String line) {
        int length = line.codePointCount(0, line.length());
        return length <= LONGEST
                ? line
                : line.substring(0, line.offsetByCodePoints(0, LONGEST - 1)) + "…";
    }
}
