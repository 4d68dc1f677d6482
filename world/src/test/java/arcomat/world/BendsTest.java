package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Lines with rounded corners. */
class BendsTest {
    /** Two straight pieces of 800 and a quarter of a circle. */
    @Test
    void aCornerBecomesAnArc() {
        List<Point> corner = List.of(new Point(0, 0), new Point(1000, 0), new Point(1000, 1000));
        List<Segment> pieces = Bends.pieces(corner, 200, false);
        double length = pieces.stream().mapToDouble(p -> p.from().distance(p.to())).sum();
        assertThat(length).isCloseTo(1600 + Math.PI * 100, within(1.0));
        Point centre = new Point(800, 200);
        assertThat(pieces.subList(1, pieces.size() - 1))
                .allMatch(piece -> Math.abs(piece.to().distance(centre) - 200) < 1e-6);
    }

    /** Whatever the points, the line has no gap and ends where it should. */
    @Property(tries = 200)
    void piecesHangTogether(
            @ForAll @Size(min = 6, max = 16) List<@DoubleRange(min = 0, max = 3000) Double> numbers,
            @ForAll @DoubleRange(min = 0, max = 500) double radius,
            @ForAll boolean ring) {
        List<Point> points = new ArrayList<>();
        for (int i = 0; i + 1 < numbers.size(); i += 2) {
            points.add(new Point(numbers.get(i), numbers.get(i + 1)));
        }
        List<Segment> pieces = Bends.pieces(points, radius, ring);
        for (int i = 1; i < pieces.size(); i++) {
            assertThat(pieces.get(i).from()).isEqualTo(pieces.get(i - 1).to());
        }
        Point first = pieces.get(0).from();
        Point last = pieces.get(pieces.size() - 1).to();
        assertThat(List.of(first.x(), first.y(), last.x(), last.y()))
                .allMatch(number -> number >= -1 && number <= 3001);
        if (ring) {
            assertThat(last).isEqualTo(first);
        } else {
            assertThat(first).isEqualTo(points.get(0));
            assertThat(last).isEqualTo(points.get(points.size() - 1));
        }
    }
}
