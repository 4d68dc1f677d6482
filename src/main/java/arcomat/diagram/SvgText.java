package arcomat.diagram;

import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Element;
import arcomat.diagram.Picture.Point;
import arcomat.source.Span;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * Writes a picture as SVG. Texts are texts: they can be selected and searched. Nothing of a model
 * is ever more than text: all of it is escaped, and there are no scripts.
 */
public final class SvgText implements Picture.Pen {
    /** How round the corners of edges are. */
    private static final double BEND = 5;

    private static final double HEAD_LENGTH = 8;
    private static final double HEAD_WIDTH = 3.5;

    private final StringBuilder text = new StringBuilder();
    private final Function<Span, Optional<String>> links;

    private SvgText(Function<Span, Optional<String>> links) {
        this.links = links;
    }

    /**
     * A picture that stands alone.
     *
     * @param links addresses of places in models, where there are such
     */
    public static String render(
            Picture picture, Theme theme, Function<Span, Optional<String>> links) {
        SvgText svg = new SvgText(links);
        svg.open(picture);
        svg.text.append("<style>\n").append(theme.css()).append("</style>\n");
        svg.text.append("<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n");
        return svg.close(picture);
    }

    /** A part of a page that brings {@link Theme#css} itself. */
    public static String embedded(Picture picture) {
        return embedded(picture, place -> Optional.empty());
    }

    /** As above, with addresses of places in models, where there are such. */
    public static String embedded(Picture picture, Function<Span, Optional<String>> links) {
        SvgText svg = new SvgText(links);
        svg.open(picture);
        return svg.close(picture);
    }

    private void open(Picture picture) {
        String width = number(Math.ceil(picture.width()));
        String height = number(Math.ceil(picture.height()));
        text.append("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"arcomat\" role=\"img\"")
                .append(" width=\"" + width + "\" height=\"" + height + "\"")
                .append(" viewBox=\"0 0 " + width + " " + height + "\">\n")
                .append("<title>" + Markup.escaped(picture.title()) + "</title>\n");
    }

    private String close(Picture picture) {
        picture.elements().forEach(this::element);
        return text.append("</svg>\n").toString();
    }

    private void element(Element element) {
        Mark mark = element.mark();
        String styles = String.join(" ", mark.styles());
        text.append("<g class=\"" + mark.kind() + (styles.isEmpty() ? "" : " " + styles) + "\"")
                .append(" data-" + mark.kind() + "=\"" + Markup.escaped(mark.name()) + "\"");
        element.ends().ifPresent(this::ends);
        mark.place()
                .map(SvgText::lineOf)
                .ifPresent(line -> text.append(" data-place=\"" + Markup.escaped(line) + "\""));
        text.append(">");
        Optional<String> link = mark.place().flatMap(links);
        link.ifPresent(address -> text.append("<a href=\"" + Markup.escaped(address) + "\">"));
        if (!mark.tooltip().isEmpty()) {
            text.append("<title>" + Markup.escaped(mark.tooltip()) + "</title>");
        }
        element.shapes().forEach(shape -> shape.draw(this));
        text.append(link.isPresent() ? "</a></g>\n" : "</g>\n");
    }

    /** For pages that light up all of a wire. */
    private void ends(Picture.Ends ends) {
        text.append(" data-in=\"" + Markup.escaped(ends.holder()) + "\"")
                .append(" data-from=\"" + Markup.escaped(ends.from()) + "\"")
                .append(" data-to=\"" + Markup.escaped(ends.to()) + "\"");
    }

    private static String lineOf(Span place) {
        return place.file().path() + ":" + place.startPosition().line();
    }

    @Override
    public void rectangle(Picture.Rectangle rectangle) {
        Box box = rectangle.box();
        text.append("<rect" + at(box.x(), box.y()))
                .append(attribute("width", box.width()) + attribute("height", box.height()))
                .append(rectangle.radius() > 0 ? attribute("rx", rectangle.radius()) : "")
                .append("/>");
    }

    @Override
    public void circle(Picture.Circle circle) {
        text.append("<circle" + attribute("cx", circle.centre().x()))
                .append(attribute("cy", circle.centre().y()))
                .append(attribute("r", circle.radius()) + "/>");
    }

    @Override
    public void line(Picture.Line line) {
        text.append("<path d=\"M" + pair(line.from()) + " L" + pair(line.to()) + "\"/>");
    }

    /** The length is said too: in another font, the text still fits where it stands. */
    @Override
    public void text(Picture.Text line) {
        double baseline = line.box().y() + line.line().lettering().ascent();
        text.append("<text class=\"" + line.line().lettering().style() + "\"")
                .append(at(line.box().x(), baseline))
                .append(attribute("textLength", line.box().width()))
                .append(" lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\">")
                .append(Markup.escaped(line.line().text()) + "</text>");
    }

    @Override
    public void arrow(Picture.Arrow arrow) {
        List<Point> points = arrow.points();
        if (!arrow.head()) {
            text.append("<path d=\"" + path(points, points.get(points.size() - 1)) + "\"/>");
            return;
        }
        Point last = points.get(points.size() - 1);
        Point before = points.get(points.size() - 2);
        double length = Math.hypot(last.x() - before.x(), last.y() - before.y());
        double right = length == 0 ? 1 : (last.x() - before.x()) / length;
        double down = length == 0 ? 0 : (last.y() - before.y()) / length;
        Point foot = last.plus(-right * HEAD_LENGTH, -down * HEAD_LENGTH);
        text.append("<path d=\"" + path(points, foot) + "\"/>")
                .append("<polygon class=\"head\" points=\"" + pair(last) + " ")
                .append(pair(foot.plus(-down * HEAD_WIDTH, right * HEAD_WIDTH)) + " ")
                .append(pair(foot.plus(down * HEAD_WIDTH, -right * HEAD_WIDTH)) + "\"/>");
    }

    /**
     * Through all points but the last, instead of which it ends at the foot of the arrow head, if
     * there is one.
     */
    private static String path(List<Point> points, Point foot) {
        StringBuilder path = new StringBuilder("M" + pair(points.get(0)));
        for (int i = 1; i < points.size() - 1; i++) {
            Point corner = points.get(i);
            Point next = i + 2 < points.size() ? points.get(i + 1) : foot;
            path.append(" L" + pair(towards(corner, points.get(i - 1))))
                    .append(" Q" + pair(corner) + " " + pair(towards(corner, next)));
        }
        return path.append(" L" + pair(foot)).toString();
    }

    private static Point towards(Point from, Point to) {
        double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
        double share = length == 0 ? 0 : Math.min(BEND, length / 2) / length;
        return from.plus((to.x() - from.x()) * share, (to.y() - from.y()) * share);
    }

    private static String at(double x, double y) {
        return attribute("x", x) + attribute("y", y);
    }

    private static String attribute(String name, double value) {
        return " " + name + "=\"" + number(value) + "\"";
    }

    private static String pair(Point point) {
        return number(point.x()) + "," + number(point.y());
    }

    /** To a tenth of a pixel. */
    private static String number(double value) {
        String exact = String.format(Locale.ROOT, "%.1f", value + 0.0);
        String shorter = exact.endsWith(".0") ? exact.substring(0, exact.length() - 2) : exact;
        return shorter.equals("-0") ? "0" : shorter;
    }
}
