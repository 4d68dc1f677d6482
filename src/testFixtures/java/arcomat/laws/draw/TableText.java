package arcomat.laws.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.Collectors;

/** An arbitrary table as text, each row on a line of its own. */
final class TableText {
    private final Draw draw;
    private final boolean events;
    private final List<Plug> inputs;
    private final List<Plug> outputs;
    private final BiFunction<Plug, List<Plug>, String> message;

    /**
     * @param message what is sent on an output, where some inputs are known to have a message
     */
    TableText(
            Draw draw,
            List<Plug> plugs,
            boolean events,
            BiFunction<Plug, List<Plug>, String> message) {
        this.draw = draw;
        this.events = events;
        this.inputs = Plug.inputs(plugs).stream().filter(each -> columned(each)).toList();
        this.outputs =
                Plug.outputs(plugs).stream()
                        .filter(each -> each.total() || draw.chance(80))
                        .toList();
        this.message = message;
    }

    /** What an event does not bring is asked for beside it, and what it may bring is a column. */
    private boolean columned(Plug input) {
        return events ? !input.latched() || draw.chance(70) : draw.chance(80);
    }

    /** A table has no first message, which an output that is late and total needs. */
    static boolean canBe(List<Plug> plugs) {
        return Plug.outputs(plugs).stream().noneMatch(each -> each.total() && each.delay() > 0);
    }

    /**
     * @param head the stereotypes
     */
    List<String> write(String head) {
        List<String> lines = new ArrayList<>();
        lines.add("    %s table {".formatted(head));
        columns("in", inputs, lines);
        columns("out", outputs, lines);
        for (int count = draw.below(6); count > 0; count--) {
            lines.add("        " + row());
        }
        lines.add("    }");
        return lines;
    }

    private static void columns(String side, List<Plug> plugs, List<String> lines) {
        if (!plugs.isEmpty()) {
            String names = plugs.stream().map(Plug::name).collect(Collectors.joining(", "));
            lines.add("        %s %s;".formatted(side, names));
        }
    }

    private String row() {
        List<Plug> present = new ArrayList<>();
        List<String> cells = new ArrayList<>();
        List<Plug> possible = inputs.stream().filter(each -> !each.latched()).toList();
        Plug event = events ? draw.one(possible) : null;
        for (Plug input : inputs) {
            boolean isOther = events && !input.latched() && input != event;
            cells.add(isOther ? "*" : asked(input, input == event, present));
        }
        StringBuilder row = new StringBuilder("|");
        cells.forEach(each -> row.append(' ').append(each).append(" |"));
        row.append(" => |");
        outputs.forEach(each -> row.append(' ').append(message.apply(each, present)).append(" |"));
        return row.append(';').toString();
    }

    /**
     * @param present gets the input where a message is known to be there
     */
    private String asked(Plug input, boolean isEvent, List<Plug> present) {
        List<String> messages = Plug.messages(input.type());
        int kind = draw.below(isEvent ? 6 : 10);
        if (kind < 6 || input.total()) {
            present.add(input);
        }
        return switch (kind) {
            case 0 -> "?";
            case 1 -> "alt {" + draw.one(messages) + ", " + draw.one(messages) + "}";
            case 2, 3, 4, 5 -> draw.one(messages);
            case 6 -> input.total() || input.latched() ? "*" : "--";
            default -> "*";
        };
    }
}
