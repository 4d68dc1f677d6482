package arcomat.pipeline.campaign;

import arcomat.pipeline.WrongUse;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One of several parts of a campaign, each about as large: whoever makes them all has made its
 * runs.
 *
 * @param number from 1
 * @param of how many there are
 */
public record CampaignPart(int number, int of) {
    private static final Pattern WRITTEN = Pattern.compile("(\\d{1,6})/(\\d{1,6})");

    /**
     * As the user writes it: {@code 3/20}.
     *
     * @throws WrongUse where it is none
     */
    public static CampaignPart parse(String written) throws WrongUse {
        Matcher matcher = WRITTEN.matcher(written);
        if (matcher.matches()) {
            int number = Integer.parseInt(matcher.group(1));
            int of = Integer.parseInt(matcher.group(2));
            if (1 <= number && number <= of) {
                return new CampaignPart(number, of);
            }
        }
        throw new WrongUse("--part %s is no part such as 3/20, the third of twenty", written);
    }

    /** The first of its runs, of so many. */
    long first(long runs) {
        return runs * (number - 1) / of;
    }

    /** The one behind its last. */
    long end(long runs) {
        return runs * number / of;
    }
}
