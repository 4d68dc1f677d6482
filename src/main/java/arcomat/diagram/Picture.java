package arcomat.diagram;

import java.util.List;

/**
 * A picture in which everything has its place, in pixels from the upper left corner.
 *
 * @param elements in the order in which they are drawn
 */
public record Picture(String title, double width, double height, List<Element> elements) {
    public Picture {
        elements = List.copyOf(elements);
    }

    /** Shapes that belong together. */
    public record Element(Mark mark, List<Shape> shapes) {
        public Element {
            shapes = List.copyOf(shapes);
        }
    }

    public sealed interface Shape {}

    public record Rectangle(Box box, double radius) implements Shape {}

    public record Line(Point from, Point to) implements Shape {}

    public record Circle(Point centre, double radius) implements Shape {}

    /** A line through points, with an arrow head at its end. */
    public record Arrow(List<Point> points) implements Shape {
        public Arrow {
            points = List.copyOf(points);
        }
    }

    /**
     * A line of text.
     *
     * @param box what it may fill
     */
    public record Text(Box box, Graph.Line line) implements Shape {}

    public record Point(double x, double y) {
        Point plus(double right, double down) {
            return new Point(x + right, y + down);
        }
    }

    public record Box(double x, double y, double width, double height) {
        Box moved(double right, double down) {
            return new Box(x + right, y + down, width, height);
        }
    }
}
