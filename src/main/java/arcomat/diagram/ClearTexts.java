package arcomat.diagram;

import arcomat.diagram.Picture.Arrow;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Point;
import arcomat.diagram.Picture.Text;

import java.util.List;
import java.util.stream.Stream;

/** Whether the arrows of a picture leave its texts alone, so that all of them can be read. */
final class ClearTexts {
    private ClearTexts() {}

    static boolean in(Picture picture) {
        List<Box> texts = shapes(picture, Text.class).map(Text::box).toList();
        return shapes(picture, Arrow.class)
                .allMatch(arrow -> texts.stream().noneMatch(text -> runsThrough(arrow, text)));
    }

    private static <S> Stream<S> shapes(Picture picture, Class<S> form) {
        return picture.elements().stream()
                .flatMap(element -> element.shapes().stream())
                .filter(form::isInstance)
                .map(form::cast);
    }

    private static boolean runsThrough(Arrow arrow, Box text) {
        List<Point> points = arrow.points();
        for (int i = 1; i < points.size(); i++) {
            Point from = points.get(i - 1);
            Point to = points.get(i);
            if (meet(from.x(), to.x(), text.x(), text.width())
                    && meet(from.y(), to.y(), text.y(), text.height())) {
                return true;
            }
        }
        return false;
    }

    /** Whether a piece of a line, which lies in right angles, reaches into a length. */
    private static boolean meet(double from, double to, double start, double length) {
        return Math.max(from, to) > start && Math.min(from, to) < start + length;
    }
}
