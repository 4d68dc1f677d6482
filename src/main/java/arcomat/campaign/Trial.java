package arcomat.campaign;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One run of a campaign, before it has been made.
 *
 * @param number from 0
 * @param seed of the world's chance
 * @param values of the world's parameters, by name, in the order of the campaign
 */
public record Trial(long number, long seed, Map<String, String> values) {
    public Trial {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }
}
