package arcomat.diagram;

import arcomat.model.Component;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;

/** Ports as they are drawn on a border: inputs on the left, outputs on the right. */
final class PortMarks {
    static final Graph.Line LEGEND = Graph.Line.small("\u25a0 sends one slice later");

    private PortMarks() {}

    /** Whether some of them are filled, which the legend explains. */
    static boolean showDelay(Component component) {
        return component.outputs().stream().anyMatch(port -> port.delay() > 0);
    }

    /**
     * The ports of a component, in the order of the text.
     *
     * @param path of the part, with a dot at its end; empty for the whole
     */
    static List<Graph.Port> of(Component component, String path) {
        List<Graph.Port> ports = new ArrayList<>();
        for (Port port : component.ports()) {
            ports.add(of(port, path));
        }
        return ports;
    }

    private static Graph.Port of(Port port, String path) {
        String type = port.type().simpleName();
        Mark mark =
                Mark.of("port", path + port.name(), port.span())
                        .telling((port.isInput() ? "in " : "out ") + type + " " + port.name());
        mark =
                port.delay() > 0
                        ? mark.styled("delayed").telling("one slice later")
                        : mark.styled("instant");
        return new Graph.Port(mark, port.isInput(), port.name() + ": " + type);
    }
}
