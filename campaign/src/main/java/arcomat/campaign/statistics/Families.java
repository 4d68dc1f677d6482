package arcomat.campaign.statistics;

import java.util.List;

/**
 * Who of those that reached the last level of a splitting goes back to the same trial of the first
 * level: they have all that happened before the first level in common, and are no independent
 * witnesses.
 *
 * @param sizes how many each such trial has as descendants; those that have none need not be named
 */
public record Families(List<Long> sizes) {
    public Families {
        sizes = List.copyOf(sizes);
        if (sizes.stream().anyMatch(size -> size < 0)) {
            throw new IllegalArgumentException("sizes " + sizes);
        }
    }

    /** How many there are. */
    public long count() {
        return sizes.stream().filter(size -> size > 0).count();
    }

    /** All members of all of them. */
    long members() {
        return sizes.stream().mapToLong(Long::longValue).sum();
    }

    /** Pairs of members of different families, each in both orders. */
    double strangers() {
        double members = members();
        return members * members - sizes.stream().mapToDouble(size -> (double) size * size).sum();
    }
}
