package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Point;

import java.util.List;
import java.util.Optional;

/**
 * Where a layout has put everything. Who finds the places is another matter: the tool has an engine
 * of its own, a browser another.
 */
public interface LayoutPlaces {
    /** Seen from the upper left corner of what it lies in. */
    Box node(Node node);

    /** The text of a closed node, seen from the node's corner. */
    Box title(Node node);

    /** Seen from its node's corner. */
    Box port(Graph.Port port);

    /** Its text, seen from its own corner. */
    Box label(Graph.Port port);

    /** Seen from the corner of the node that holds the edge. */
    Route route(Node holder, Edge edge);

    /**
     * The way of an edge.
     *
     * @param forks points where lines that share a way part
     * @param label where its captions stand, below each other; empty where it has none
     */
    record Route(List<Point> points, List<Point> forks, Optional<Box> label) {
        public Route {
            points = List.copyOf(points);
            forks = List.copyOf(forks);
        }
    }
}
