package arcomat.laws.naive;

import arcomat.laws.naive.NaiveBehaviour.Move;
import arcomat.laws.naive.NaiveBehaviour.Moves;
import arcomat.laws.naive.NaiveBehaviour.State;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** One automaton, as text, that shows what a composition shows. */
public final class Flattened {
    private static final int MOST_STATES = 12;
    private static final int MOST_TRANSITIONS = 150;

    private final NaiveBehaviour behaviour;
    private final Map<State, Integer> numbers = new LinkedHashMap<>();
    private final List<State> states = new ArrayList<>();
    private final List<String> transitions = new ArrayList<>();
    private final List<String> initials = new ArrayList<>();
    private boolean errors;

    private Flattened(NaiveBehaviour behaviour) {
        this.behaviour = behaviour;
    }

    /**
     * The component as an atomic one, each element on a line.
     *
     * @return empty where it has many states or large types
     */
    public static Optional<List<String>> of(Component component, String folder) {
        boolean small =
                NaiveQuestion.ports(component).stream()
                        .allMatch(p -> NaiveValues.isSmall(p.type()));
        if (!small || component.profile() == Component.Profile.EVENT_DRIVEN) {
            return Optional.empty();
        }
        Flattened flat = new Flattened(NaiveBehaviour.of(component, List.of(), List.of(), true));
        try {
            return flat.explore() ? Optional.of(flat.text(folder)) : Optional.empty();
        } catch (NaiveComparison.TooMuch much) {
            return Optional.empty();
        }
    }

    private boolean explore() {
        for (Move start : behaviour.starts().moves()) {
            String sends = block(start);
            String line = "        initial s" + number(start.next()) + sends + ";";
            if (!initials.contains(line)) {
                initials.add(line);
            }
        }
        List<Map<String, Value>> letters =
                NaiveQuestion.letters(behaviour.component(), behaviour.component(), List.of());
        for (int i = 0; i < states.size(); i++) {
            for (Map<String, Value> letter : letters) {
                Moves moves = behaviour.moves(states.get(i), letter);
                errors |= moves.error();
                if (moves.error() && !moves.moves().isEmpty()) {
                    return false;
                }
                for (Move move : moves.moves()) {
                    String line =
                            "        s%d -> s%d {%s}%s;"
                                    .formatted(i, number(move.next()), items(letter), block(move));
                    transitions.add(line);
                }
            }
            if (states.size() > MOST_STATES || transitions.size() > MOST_TRANSITIONS) {
                return false;
            }
        }
        return true;
    }

    private int number(State state) {
        return numbers.computeIfAbsent(
                state,
                each -> {
                    states.add(each);
                    return states.size() - 1;
                });
    }

    private static String items(Map<String, Value> letter) {
        return letter.entrySet().stream()
                .map(e -> e.getKey() + " == " + (e.getValue() == null ? "--" : e.getValue()))
                .collect(Collectors.joining(", "));
    }

    private String block(Move move) {
        List<String> items = new ArrayList<>();
        for (Port port : behaviour.component().outputs()) {
            boolean late = behaviour.isLate(port.name());
            Slot slot =
                    late
                            ? behaviour.due(move.next(), port.name())
                            : move.outputs().getOrDefault(port.name(), Slot.SILENCE);
            if (slot.message() != null) {
                items.add(port.name() + " = " + slot.message());
            }
        }
        return items.isEmpty() ? "" : " / {" + String.join(", ", items) + "}";
    }

    private List<String> text(String folder) {
        List<String> lines = new ArrayList<>();
        lines.add("package " + folder + ";");
        lines.add("component Main {");
        for (Port port : behaviour.component().ports()) {
            boolean instant = !port.isInput() && !behaviour.isLate(port.name());
            String mark = port.total() ? "<<total>> " : instant ? "<<delay = \"0\">> " : "";
            String direction = port.isInput() ? "in" : "out";
            lines.add(
                    "    port %s%s %s %s;"
                            .formatted(mark, direction, port.type().name(), port.name()));
        }
        lines.add("    <<completion = \"%s\">> automaton {".formatted(errors ? "error" : "ignore"));
        for (int i = 0; i < states.size(); i++) {
            lines.add("        state s" + i + ";");
        }
        lines.addAll(initials);
        lines.addAll(transitions);
        lines.add("    }");
        lines.add("}");
        return lines;
    }
}
