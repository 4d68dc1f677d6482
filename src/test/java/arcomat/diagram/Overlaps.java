package arcomat.diagram;

import arcomat.diagram.Drawn.Area;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** What lies upon each other in a picture and should not. */
final class Overlaps {
    /** Numbers are written to a tenth; borders may touch. */
    private static final double TOLERANCE = 0.3;

    private final List<String> found = new ArrayList<>();

    private Overlaps() {}

    static List<String> in(String svg) {
        Drawn drawn = Drawn.in(svg);
        Overlaps overlaps = new Overlaps();
        overlaps.boxes(drawn.boxes);
        overlaps.apart(drawn.texts, drawn.texts);
        overlaps.apart(drawn.ports, drawn.ports);
        overlaps.apart(drawn.ports, drawn.texts);
        overlaps.textsAndBorders(drawn);
        overlaps.arrows(drawn);
        overlaps.inside(drawn);
        return overlaps.found;
    }

    private void boxes(List<Area> boxes) {
        for (int i = 0; i < boxes.size(); i++) {
            for (int j = i + 1; j < boxes.size(); j++) {
                Rectangle2D one = boxes.get(i).place();
                Rectangle2D other = boxes.get(j).place();
                if (meet(one, other) && !one.contains(other) && !other.contains(one)) {
                    found.add(boxes.get(i).name() + " overlaps " + boxes.get(j).name());
                }
            }
        }
    }

    private void apart(List<Area> some, List<Area> others) {
        for (int i = 0; i < some.size(); i++) {
            for (int j = some == others ? i + 1 : 0; j < others.size(); j++) {
                if (meet(some.get(i).place(), others.get(j).place())) {
                    found.add(some.get(i).name() + " overlaps " + others.get(j).name());
                }
            }
        }
    }

    private void textsAndBorders(Drawn drawn) {
        for (Area text : drawn.texts) {
            for (Area box : drawn.boxes) {
                if (meet(text.place(), box.place()) && !box.place().contains(text.place())) {
                    found.add(text.name() + " crosses the border of " + box.name());
                }
            }
        }
    }

    private void arrows(Drawn drawn) {
        for (Drawn.Piece piece : drawn.pieces) {
            for (Area text : drawn.texts) {
                if (piece.line().intersects(smaller(text.place()))) {
                    found.add(piece.name() + " runs through " + text.name());
                }
            }
        }
    }

    private void inside(Drawn drawn) {
        for (List<Area> areas : List.of(drawn.boxes, drawn.ports, drawn.texts)) {
            for (Area area : areas) {
                if (!drawn.whole.contains(area.place())) {
                    found.add(area.name() + " is cut off");
                }
            }
        }
    }

    private static boolean meet(Rectangle2D one, Rectangle2D other) {
        return smaller(one).intersects(smaller(other));
    }

    private static Rectangle2D smaller(Rectangle2D full) {
        return new Rectangle2D.Double(
                full.getX() + TOLERANCE,
                full.getY() + TOLERANCE,
                full.getWidth() - 2 * TOLERANCE,
                full.getHeight() - 2 * TOLERANCE);
    }
}
