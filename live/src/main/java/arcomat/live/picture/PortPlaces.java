package arcomat.live.picture;

import arcomat.diagram.Graph;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Lettering;

import java.util.List;

/**
 * Where the ports of a closed node stand: below its title, inputs on the left, outputs on the
 * right, in the order of the text.
 */
record PortPlaces(Node node, double top, double width) {
    static final double SIZE = 9;

    /** Between a port and its text. */
    static final double GAP = 4;

    private static final double ROW = 20;

    /** Between texts on the left and on the right. */
    private static final double MIDDLE = 20;

    /** What texts on both sides need. */
    static double width(Node node) {
        return widest(node, true) + widest(node, false) + MIDDLE;
    }

    static double height(Node node, double top) {
        long rows = Math.max(side(node, true).size(), side(node, false).size());
        return rows == 0 ? top : top + rows * ROW;
    }

    double x(Graph.Port port) {
        return port.left() ? -SIZE / 2 : width - SIZE / 2;
    }

    double y(Graph.Port port) {
        return top + side(node, port.left()).indexOf(port) * ROW;
    }

    private static List<Graph.Port> side(Node node, boolean left) {
        return node.ports().stream().filter(port -> port.left() == left).toList();
    }

    private static double widest(Node node, boolean left) {
        return side(node, left).stream()
                .mapToDouble(port -> Lettering.SMALL.width(port.label()) + SIZE)
                .max()
                .orElse(0);
    }
}
