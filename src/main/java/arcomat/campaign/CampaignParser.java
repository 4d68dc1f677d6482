package arcomat.campaign;

import arcomat.campaign.Campaign.Comparison;
import arcomat.campaign.Campaign.Search;
import arcomat.campaign.Campaign.Split;
import arcomat.campaign.Demand.Side;
import arcomat.campaign.Variation.Choice;
import arcomat.campaign.Variation.Domain;
import arcomat.campaign.Variation.Range;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.world.Word;
import arcomat.world.Words;
import arcomat.world.Words.Unreadable;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** Reads campaigns: one thing per line. docs/campaigns.md lists what there is. */
public final class CampaignParser {
    static final String SYNTAX = "ARC1130";
    static final String TWICE = "ARC1131";
    static final String MEANINGLESS = "ARC1132";

    private static final List<String> STATEMENTS =
            List.of(
                    "world", "vary", "measure", "event", "watch", "sample", "seeds", "stop",
                    "require", "compare", "worst", "split");
    private static final double FAR = 999_999_999;
    private static final int MOST = 999_999_999;

    /** In mm: no floor is larger. */
    private static final int FARTHEST = 1_000_000;

    private static final List<String> DISTANCES =
            List.of(Quantity.DISTANCE.word(), Quantity.CLEARANCE.word());

    private final SourceFile file;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final Map<String, Span> once = new LinkedHashMap<>();
    private final Map<String, Variation> variations = new LinkedHashMap<>();
    private final Map<String, Measure> measures = new LinkedHashMap<>();
    private final Map<String, Watched> watches = new LinkedHashMap<>();
    private final List<Demand> demands = new ArrayList<>();
    private Campaign.@Nullable World world;
    private @Nullable Plan plan;
    private long firstSeed = 1;
    private boolean stopsWhenDecided;
    private @Nullable Comparison comparison;
    private @Nullable Search search;
    private @Nullable Split split;

    private CampaignParser(SourceFile file) {
        this.file = file;
    }

    /**
     * A campaign that was read.
     *
     * @param campaign absent if there are findings
     * @param findings in the order of the text
     */
    public record Reading(Optional<Campaign> campaign, List<Diagnostic> findings) {
        public Reading {
            findings = List.copyOf(findings);
        }
    }

    public static Reading parse(SourceFile file) {
        CampaignParser parser = new CampaignParser(file);
        for (int line = 1; line <= file.lineCount(); line++) {
            Words words = Words.ofLine(file, line, SYNTAX);
            if (!words.isEmpty()) {
                parser.read(words);
            }
        }
        return parser.result();
    }

    private void read(Words words) {
        try {
            statement(words, words.choice("what a campaign says", STATEMENTS));
            words.end();
        } catch (Unreadable e) {
            findings.add(e.finding());
        }
    }

    private void statement(Words words, Word what) throws Unreadable {
        switch (what.text()) {
            case "vary" -> vary(words);
            case "measure" -> define(Measure.number(words));
            case "event" -> define(Measure.event(words));
            case "watch" -> define(Watched.of(words));
            case "require" -> demands.add(requirement(words));
            default -> {
                unique(what.text(), what.place());
                single(words, what.text());
            }
        }
    }

    private void single(Words words, String what) throws Unreadable {
        switch (what) {
            case "world" -> {
                Word path = words.next("the path of a world");
                world = new Campaign.World(path.text(), path.place());
            }
            case "sample" -> plan = plan(words);
            case "seeds" -> {
                words.expect("from");
                firstSeed = words.count("the first seed", 0, MOST);
            }
            case "stop" -> {
                words.expect("decided");
                stopsWhenDecided = true;
            }
            case "compare" -> comparison = comparison(words);
            case "worst" -> search = search(words);
            default -> split = split(words);
        }
    }

    private void unique(String name, Span place) throws Unreadable {
        Span before = once.putIfAbsent(name, place);
        if (before != null) {
            throw new Unreadable(
                    Diagnostic.error(TWICE, place, "there are two '" + name + "'")
                            .withRelated(before, "the first one"));
        }
    }

    private void define(Measure measure) throws Unreadable {
        requireColumn(measure.name(), measure.place());
        measures.put(measure.name(), measure);
    }

    private void define(Watched watched) throws Unreadable {
        requireColumn(watched.name(), watched.place());
        watches.put(watched.name(), watched);
    }

    private void requireColumn(String name, Span place) throws Unreadable {
        unique("column " + name, place);
        boolean taken =
                Quantity.words(true).contains(name)
                        || Quantity.words(false).contains(name)
                        || TableText.NAMES.contains(name);
        if (taken) {
            throw new Unreadable(
                    Diagnostic.error(TWICE, place, "every table has a column '" + name + "'"));
        }
    }

    /** The columns that the text has named so far, and those that every table has. */
    private List<String> columns(boolean event) {
        List<String> names = new ArrayList<>(Quantity.words(event));
        measures.values().stream()
                .filter(each -> each.fold().isEvent() == event)
                .forEach(each -> names.add(each.name()));
        if (event) {
            names.addAll(watches.keySet());
        }
        return names;
    }

    private void vary(Words words) throws Unreadable {
        Word name = words.next("the name of a parameter of the world");
        unique("vary " + name.text(), name.place());
        Domain domain =
                words.choice("how it varies", List.of("from", "of")).text().equals("of")
                        ? choice(words)
                        : range(words);
        variations.put(name.text(), new Variation(name.text(), domain, name.place()));
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

    private static Plan plan(Words words) throws Unreadable {
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

    private Demand requirement(Words words) throws Unreadable {
        Word start = words.next("an event, or a number in percent");
        if (Character.isDigit(start.text().charAt(0))) {
            words.back();
            double quantile = words.number("percent of the runs", 0.001, 99.999) / 100;
            words.expect("of");
            String measure = words.choice("a measure", columns(false)).text();
            Side side = side(words);
            double bound = words.number("a bound", -FAR, FAR);
            return new Demand.Share(
                    quantile, measure, side, bound, confidence(words), start.place());
        }
        words.back();
        String event = words.choice("an event", columns(true)).text();
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

    private Comparison comparison(Words words) throws Unreadable {
        Word parameter = words.next("the name of a parameter that varies");
        words.expect("by");
        String event = words.choice("an event", columns(true)).text();
        return new Comparison(parameter.text(), event, confidence(words), parameter.place());
    }

    private Search search(Words words) throws Unreadable {
        Word which = words.choice("which is the worst", List.of("smallest", "largest"));
        String measure = words.choice("a measure", columns(false)).text();
        words.expect("runs");
        int runs = words.count("how many runs", 10, MOST);
        Side side = which.text().equals("smallest") ? Side.BELOW : Side.ABOVE;
        return new Search(side, measure, runs, which.place());
    }

    /** Whole millimetres: more is finer than a step of the world. */
    private static Split split(Words words) throws Unreadable {
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

    private Reading result() {
        requireThere(world != null, "a world: write 'world FILE'");
        requireThere(plan != null, "a number of runs: write 'sample random N'");
        if (findings.isEmpty()) {
            checkColumns();
            checkComparison();
            checkSearch();
            Optional.ofNullable(split).ifPresent(this::checkSplit);
        }
        findings.sort(Diagnostic.ORDER);
        return new Reading(
                findings.isEmpty() ? Optional.of(campaign()) : Optional.empty(), findings);
    }

    private Campaign campaign() {
        return new Campaign(
                Objects.requireNonNull(world),
                List.copyOf(variations.values()),
                List.copyOf(measures.values()),
                List.copyOf(watches.values()),
                Objects.requireNonNull(plan),
                firstSeed,
                stopsWhenDecided,
                demands,
                Optional.ofNullable(comparison),
                Optional.ofNullable(search),
                Optional.ofNullable(split));
    }

    /** What is wrong already is told alone: it may be the reason. */
    private void requireThere(boolean there, String what) {
        if (!there && findings.isEmpty()) {
            findings.add(Diagnostic.error(SYNTAX, file.span(0, 0), "a campaign has " + what));
        }
    }

    /** Parameters are columns as well. */
    private void checkColumns() {
        measures.values().forEach(each -> requireNoParameter(each.name(), each.place()));
        watches.values().forEach(each -> requireNoParameter(each.name(), each.place()));
    }

    private void requireNoParameter(String name, Span place) {
        Variation parameter = variations.get(name);
        if (parameter != null) {
            findings.add(
                    Diagnostic.error(TWICE, place, "a parameter has the column '" + name + "'")
                            .withRelated(parameter.place(), "the parameter"));
        }
    }

    private void checkComparison() {
        if (comparison == null) {
            return;
        }
        Variation compared = variations.get(comparison.parameter());
        boolean two =
                compared != null
                        && compared.domain().match(range -> false, c -> c.words().size() == 2);
        if (!two) {
            String name = comparison.parameter();
            findings.add(
                    Diagnostic.error(
                            MEANINGLESS,
                            comparison.place(),
                            "what is compared are two words: write 'vary %s of OLD NEW'"
                                    .formatted(name)));
        }
    }

    private void checkSearch() {
        if (search != null
                && variations.values().stream().noneMatch(each -> each.domain() instanceof Range)) {
            findings.add(
                    Diagnostic.error(
                            MEANINGLESS,
                            search.place(),
                            "a search needs a range to search in: write 'vary NAME from LOW to"
                                    + " HIGH'"));
        }
    }

    private void checkSplit(Split asked) {
        asked.columns().stream()
                .filter(
                        name ->
                                measures.containsKey(name)
                                        || watches.containsKey(name)
                                        || variations.containsKey(name))
                .forEach(name -> tellTaken(name, asked.place()));
        if (comparison != null) {
            findings.add(
                    Diagnostic.error(
                            MEANINGLESS,
                            asked.place(),
                            "a splitting is about one probability: write a campaign for each of"
                                    + " the two words that are compared"));
        }
    }

    private void tellTaken(String name, Span place) {
        findings.add(
                Diagnostic.error(
                        TWICE,
                        place,
                        "the levels have columns such as '%s': call yours otherwise"
                                .formatted(name)));
    }
}
