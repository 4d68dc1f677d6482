package arcomat.campaign;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The runs that somebody wants to see again: the first ones that went wrong, and the closest calls.
 */
final class Notable {
    private static final int EACH = 10;

    private final int distance;
    private final List<Integer> bad;
    private final List<Row> wrong = new ArrayList<>();
    private final List<Row> close = new ArrayList<>();

    Notable(Campaign campaign) {
        this.distance = campaign.column(Quantity.DISTANCE.word());
        this.bad =
                List.of(
                        campaign.column(Quantity.COLLISION.word()),
                        campaign.column(Quantity.FAILURE.word()),
                        campaign.column(Quantity.DEADLOCK.word()));
    }

    void see(Row row) {
        if (!row.wasMade()) {
            return;
        }
        if (bad.stream().anyMatch(row::happened)) {
            if (wrong.size() < EACH) {
                wrong.add(row);
            }
        } else if (!Double.isNaN(row.answer(distance))) {
            close.add(row);
            if (close.size() > EACH) {
                close.remove(farthest());
            }
        }
    }

    /** Of equals the last: the table's order decides, not who came first. */
    private Row farthest() {
        return close.stream()
                .max(
                        Comparator.<Row>comparingDouble(row -> row.answer(distance))
                                .thenComparingLong(row -> row.trial().number()))
                .orElseThrow();
    }

    List<Row> rows() {
        List<Row> all = new ArrayList<>(wrong);
        close.stream()
                .sorted(
                        Comparator.<Row>comparingDouble(row -> row.answer(distance))
                                .thenComparingLong(row -> row.trial().number()))
                .limit(Math.max(0, EACH - wrong.size()))
                .forEach(all::add);
        return all;
    }
}
