package arcomat.campaign.against;

import arcomat.campaign.Row;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;

/** The rows of a table seed by seed: in a table, what shares a seed stands together. */
final class SeedGroups {
    private final Iterator<Row> rows;
    private Optional<Row> next;

    SeedGroups(Iterator<Row> rows) {
        this.rows = rows;
        this.next = advance();
    }

    private Optional<Row> advance() {
        return rows.hasNext() ? Optional.of(rows.next()) : Optional.empty();
    }

    /** The seed of the rows that come next; empty behind the last. */
    Optional<Long> seed() {
        return next.map(row -> row.trial().seed());
    }

    /** The rows of that seed. */
    List<Row> take() {
        Optional<Long> seed = seed();
        List<Row> group = new ArrayList<>();
        while (next.isPresent() && seed().equals(seed)) {
            group.add(next.get());
            next = advance();
        }
        return group;
    }
}
