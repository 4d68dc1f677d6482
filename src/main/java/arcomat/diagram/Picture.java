package arcomat.diagram;

import java.util.List;
import java.util.Optional;

/**
 * A picture in which everything has its place, in pixels from the upper left corner.
 *
 * @param elements in the order in which they are drawn
 */
public record Picture(String title, double width, double height, List<Element> elements) {
    public Picture {
        elements = List.copyOf(elements);
    }

    /**
     * Shapes that belong together.
     *
     * @param ends what a line connects; empty for all but lines
     */
    public record Element(Mark mark, Optional<Ends> ends, List<Shape> shapes) {
        public Element {
            shapes = List.copyOf(shapes);
        }

        static Element of(Mark mark, List<Shape> shapes) {
            return new Element(mark, Optional.empty(), shapes);
        }
    }

    /**
     * Names of what a line connects: of ports, or of nodes without any.
     *
     * @param holder the node that it lies in
     */
    public record Ends(String holder, String from, String to) {}

    /** What can be drawn. */
    public sealed interface Shape {
        /** Asks for the answer of its form: a pen that does not know one does not compile. */
        void draw(Pen pen);
    }

    /** What draws, each form of a shape in its own way. */
    public interface Pen {
        void rectangle(Rectangle rectangle);

        void line(Line line);

        void circle(Circle circle);

        void arrow(Arrow arrow);

        void text(Text text);
    }

    public record Rectangle(Box box, double radius) implements Shape {
        @Override
        public void draw(Pen pen) {
            pen.rectangle(this);
        }
    }

    public record Line(Point from, Point to) implements Shape {
        @Override
        public void draw(Pen pen) {
            pen.line(this);
        }
    }

    public record Circle(Point centre, double radius) implements Shape {
        @Override
        public void draw(Pen pen) {
            pen.circle(this);
        }
    }

    /**
     * A line through points.
     *
     * @param head whether there is an arrow head at its end
     */
    public record Arrow(List<Point> points, boolean head) implements Shape {
        public Arrow {
            points = List.copyOf(points);
        }

        @Override
        public void draw(Pen pen) {
            pen.arrow(this);
        }
    }

    /**
     * A line of text.
     *
     * @param box what it may fill
     */
    public record Text(Box box, Graph.Line line) implements Shape {
        @Override
        public void draw(Pen pen) {
            pen.text(this);
        }
    }

    public record Point(double x, double y) {
        public Point plus(double right, double down) {
            return new Point(x + right, y + down);
        }
    }

    public record Box(double x, double y, double width, double height) {
        public Box moved(double right, double down) {
            return new Box(x + right, y + down, width, height);
        }
    }
}
