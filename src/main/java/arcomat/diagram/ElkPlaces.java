package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Point;

import org.eclipse.elk.core.math.KVector;
import org.eclipse.elk.core.options.CoreOptions;
import org.eclipse.elk.core.util.ElkUtil;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.ElkPort;
import org.eclipse.elk.graph.ElkShape;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Reads from a graph of the Eclipse Layout Kernel, after its layout, where everything is. */
record ElkPlaces(
        Map<Node, ElkNode> nodes, Map<Graph.Port, ElkPort> ports, Map<Edge, List<ElkEdge>> edges)
        implements LayoutPlaces {
    /** Between a port and its text outside: nothing leads to it there. */
    private static final double GAP = 4;

    @Override
    public Box node(Node node) {
        return box(placed(node));
    }

    @Override
    public Box title(Node node) {
        return box(placed(node).getLabels().get(0));
    }

    @Override
    public Box port(Graph.Port port) {
        return box(placed(port));
    }

    @Override
    public Box label(Graph.Port port) {
        ElkPort place = placed(port);
        Box box = box(place.getLabels().get(0));
        boolean outside = box.x() < 0 == port.left();
        double y = (place.getHeight() - box.height()) / 2;
        return outside
                ? new Box(
                        port.left() ? -box.width() - GAP : place.getWidth() + GAP,
                        y,
                        box.width(),
                        box.height())
                : box;
    }

    /**
     * Where it lies is said from the innermost node on that has both its ends.
     *
     * @param holder all nodes inside it lie between: one graph may be drawn twice
     */
    @Override
    public Route route(Node holder, Edge edge) {
        List<ElkEdge> placed = Objects.requireNonNull(edges.get(edge));
        Set<ElkNode> inside = holder.inside().stream().map(nodes::get).collect(Collectors.toSet());
        double x = 0;
        double y = 0;
        ElkNode inner = placed.get(0).getContainingNode();
        while (inside.contains(inner)) {
            x += inner.getX();
            y += inner.getY();
            inner = inner.getParent();
        }
        List<Point> points = new ArrayList<>();
        List<Point> forks = new ArrayList<>();
        for (ElkEdge piece : placed) {
            for (KVector point : ElkUtil.createVectorChain(piece.getSections().get(0))) {
                points.add(new Point(point.x + x, point.y + y));
            }
            for (KVector fork : piece.getProperty(CoreOptions.JUNCTION_POINTS)) {
                forks.add(new Point(fork.x + x, fork.y + y));
            }
        }
        Box corner = new Box(x, y, 0, 0);
        Optional<Box> label =
                placed.get(0).getLabels().stream()
                        .map(each -> box(each).moved(corner.x(), corner.y()))
                        .findFirst();
        return new Route(points, forks, label);
    }

    private ElkNode placed(Node node) {
        return Objects.requireNonNull(nodes.get(node));
    }

    private ElkPort placed(Graph.Port port) {
        return Objects.requireNonNull(ports.get(port));
    }

    private static Box box(ElkShape shape) {
        return new Box(shape.getX(), shape.getY(), shape.getWidth(), shape.getHeight());
    }
}
