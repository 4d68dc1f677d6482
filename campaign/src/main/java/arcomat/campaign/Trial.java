package arcomat.campaign;

import arcomat.world.Seeds;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One run of a campaign, before it has been made.
 *
 * @param number from 0
 * @param seeds of the world's chance
 * @param values of the world's parameters, by name, in the order of the campaign
 */
public record Trial(long number, Seeds seeds, Map<String, String> values) {
    public Trial {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }

    /** One seed draws everything. */
    public Trial(long number, long seed, Map<String, String> values) {
        this(number, Seeds.of(seed), values);
    }

    /** The first of its seeds, and mostly the only one. */
    public long seed() {
        return seeds.first();
    }
}
