package arcomat.campaign;

import arcomat.campaign.Campaign.Comparison;
import arcomat.campaign.Campaign.Search;
import arcomat.campaign.Campaign.Split;
import arcomat.campaign.Demand.Side;
import arcomat.campaign.Variation.Choice;
import arcomat.campaign.Variation.Domain;
import arcomat.campaign.Variation.Range;
import arcomat.world.Word;
import arcomat.world.Words;
import arcomat.world.Words.Unreadable;

import java.util.ArrayList;
import java.util.List;

/**
 * What one line of a campaign says, read for itself.
 *
 * @param events names of columns that may be asked about in this line
 * @param measures likewise
 */
record CampaignPhrases(List<String> events, List<String> measures) {
    /** Runs, seeds: a world reads no greater numbers. */
    static final int MOST = 999_999_999;

    private static final double FAR = 999_999_999;

    /** In mm: no floor is larger. */
    private static final int FARTHEST = 1_000_000;

    private static final List<String> DISTANCES =
            List.of(Quantity.DISTANCE.word(), Quantity.CLEARANCE.word());

    /** How a parameter varies, behind its name. */
    static Domain domain(Words words) throws Unreadable {
        return words.choice("how it varies", List.of("from", "of")).text().equals("of")
                ? choice(words)
                : range(words);
    }

    private static Range range(Words words) throws Unreadable {
        double low = words.number("the least value", -FAR, FAR);
        words.expect("to");
        Word end = words.next("the greatest value");
        words.back();
        double high = words.number("the greatest value", -FAR, FAR);
        boolean whole = words.take("whole");
        if (high < low) {
            throw words.wrong(end, "the greatest value is smaller than the least");
        }
        if (whole && (low != Math.rint(low) || high != Math.rint(high))) {
            throw words.wrong(end, "whole numbers lie between whole numbers");
        }
        return new Range(low, high, whole);
    }

    private static Choice choice(Words words) throws Unreadable {
        List<String> all = new ArrayList<>();
        do {
            Word word = words.next("a value");
            if (all.contains(word.text())) {
                throw words.wrong(word, "'" + word.text() + "' stands here twice");
            }
            all.add(word.text());
        } while (words.hasNext());
        return new Choice(all);
    }

    /** {@code sample}, behind its first word. */
    static Plan plan(Words words) throws Unreadable {
        String way = words.choice("a way to sample", List.of("random", "latin", "grid")).text();
        if (way.equals("grid")) {
            int steps = words.count("steps of each range", 1, 1000);
            int seeds = 1;
            if (words.take("seeds")) {
                seeds = words.count("seeds at each point", 1, MOST);
            }
            return new Plan.Grid(steps, seeds);
        }
        int runs = words.count("how many runs", 1, MOST);
        return way.equals("latin") ? new Plan.Latin(runs) : new Plan.Random(runs);
    }

    /** {@code require}, behind its first word. */
    Demand demand(Words words) throws Unreadable {
        Word start = words.next("an event, or a number in percent", events);
        if (Character.isDigit(start.text().charAt(0))) {
            words.back();
            double quantile = words.number("percent of the runs", 0.001, 99.999) / 100;
            words.expect("of");
            String measure = words.choice("a measure", measures).text();
            Side side = side(words);
            double bound = words.number("a bound", -FAR, FAR);
            return new Demand.Share(
                    quantile, measure, side, bound, confidence(words), start.place());
        }
        words.back();
        String event = words.choice("an event", events).text();
        Side side = side(words);
        double bound = probability(words);
        return new Demand.Probability(event, side, bound, confidence(words), start.place());
    }

    private static double probability(Words words) throws Unreadable {
        Word written = words.next("a probability");
        words.back();
        double bound = words.number("a probability", 0, 1);
        if (bound == 0 || bound == 1) {
            throw words.wrong(
                    written,
                    "no number of runs shows what never or always happens: a bound lies between 0"
                            + " and 1");
        }
        return bound;
    }

    private static Side side(Words words) throws Unreadable {
        return words.choice("the side", List.of("below", "above")).text().equals("below")
                ? Side.BELOW
                : Side.ABOVE;
    }

    /** 95 percent where nothing is said. */
    private static double confidence(Words words) throws Unreadable {
        return words.take("at") ? words.number("a confidence in percent", 51, 99.9999) / 100 : 0.95;
    }

    /** {@code compare}, behind its first word. */
    Comparison comparison(Words words) throws Unreadable {
        Word parameter = words.next("the name of a parameter that varies");
        words.expect("by");
        String event = words.choice("an event", events).text();
        return new Comparison(parameter.text(), event, confidence(words), parameter.place());
    }

    /** {@code worst}, behind its first word. */
    Search search(Words words) throws Unreadable {
        Word which = words.choice("which is the worst", List.of("smallest", "largest"));
        String measure = words.choice("a measure", measures).text();
        words.expect("runs");
        int runs = words.count("how many runs", 10, MOST);
        Side side = which.text().equals("smallest") ? Side.BELOW : Side.ABOVE;
        return new Search(side, measure, runs, which.place());
    }

    /**
     * {@code split}, behind its first word. Whole millimetres: more is finer than a step of the
     * world.
     */
    static Split split(Words words) throws Unreadable {
        words.expect("on");
        Word measure = words.choice("a distance", DISTANCES);
        words.expect("levels");
        List<Integer> levels = new ArrayList<>();
        do {
            Word written = words.next("a level in mm");
            words.back();
            int level = words.count("a level in mm", 1, FARTHEST);
            if (!levels.isEmpty() && level >= levels.get(levels.size() - 1)) {
                throw words.wrong(written, "levels fall: each is nearer than the one before");
            }
            levels.add(level);
        } while (!words.take("runs"));
        int runs = words.count("how many runs of each level", 10, MOST);
        return new Split(measure.text(), levels, runs, measure.place());
    }
}
