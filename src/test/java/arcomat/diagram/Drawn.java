package arcomat.diagram;

import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

import javax.xml.parsers.DocumentBuilderFactory;

/** What an SVG shows, read back from its text: who looks at a picture sees no more. */
final class Drawn {
    private static final Set<String> BOXES =
            Set.of("frame", "part", "state", "group", "enum", "class");

    /** Letters reach from here above the line to there below, in units of the size. */
    private static final double ASCENT = 0.74;

    private static final double DESCENT = 0.22;

    record Area(String name, Rectangle2D place) {}

    record Piece(String name, Line2D line) {}

    final List<Area> boxes = new ArrayList<>();
    final List<Area> ports = new ArrayList<>();
    final List<Area> texts = new ArrayList<>();
    final List<Piece> pieces = new ArrayList<>();
    final Rectangle2D whole;

    private Drawn(Document svg) {
        Element root = svg.getDocumentElement();
        String[] view = root.getAttribute("viewBox").split(" ");
        whole = new Rectangle2D.Double(0, 0, number(view[2]), number(view[3]));
        for (Element group : all(root, "g")) {
            String kind = group.getAttribute("class").split(" ")[0];
            String name = kind + " " + group.getAttribute("data-" + kind);
            for (Element rectangle : all(group, "rect")) {
                Area area = new Area(name, rectangle(rectangle));
                if (BOXES.contains(kind)) {
                    boxes.add(area);
                } else if (kind.equals("port")) {
                    ports.add(area);
                }
            }
            all(group, "text").forEach(text -> texts.add(text(name, text)));
            if (kind.equals("arrow") || kind.equals("connector")) {
                all(group, "path").forEach(path -> read(name, path.getAttribute("d")));
            }
        }
    }

    static Drawn in(String svg) {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            InputSource source = new InputSource(new StringReader(svg));
            return new Drawn(factory.newDocumentBuilder().parse(source));
        } catch (Exception e) {
            throw new AssertionError("no XML: " + svg, e);
        }
    }

    private static List<Element> all(Element parent, String tag) {
        NodeList found = parent.getElementsByTagName(tag);
        List<Element> elements = new ArrayList<>();
        for (int i = 0; i < found.getLength(); i++) {
            elements.add((Element) found.item(i));
        }
        return elements;
    }

    private static Rectangle2D rectangle(Element e) {
        return new Rectangle2D.Double(
                number(e, "x"), number(e, "y"), number(e, "width"), number(e, "height"));
    }

    private static Area text(String name, Element e) {
        double size = e.getAttribute("class").equals("small") ? 11 : 13;
        double top = number(e, "y") - ASCENT * size;
        Rectangle2D place =
                new Rectangle2D.Double(
                        number(e, "x"), top, number(e, "textLength"), (ASCENT + DESCENT) * size);
        return new Area(name + " '" + e.getTextContent() + "'", place);
    }

    private void read(String name, String path) {
        double x = 0;
        double y = 0;
        for (String step : path.split("(?=[MLQ])")) {
            String[] numbers = step.strip().substring(1).split("[ ,]+");
            double nextX = number(numbers[numbers.length - 2]);
            double nextY = number(numbers[numbers.length - 1]);
            if (!step.startsWith("M")) {
                pieces.add(new Piece(name, new Line2D.Double(x, y, nextX, nextY)));
            }
            x = nextX;
            y = nextY;
        }
    }

    private static double number(Element e, String attribute) {
        return number(e.getAttribute(attribute));
    }

    private static double number(String text) {
        return Double.parseDouble(text);
    }
}
