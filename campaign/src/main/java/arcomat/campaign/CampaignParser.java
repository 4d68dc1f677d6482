package arcomat.campaign;

import arcomat.campaign.Campaign.Comparison;
import arcomat.campaign.Campaign.Search;
import arcomat.campaign.Campaign.Split;
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

    private final SourceFile file;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final Map<String, Span> once = new LinkedHashMap<>();
    private final Map<String, Variation> variations = new LinkedHashMap<>();
    private final List<Measure> measures = new ArrayList<>();
    private final List<Watched> watches = new ArrayList<>();
    private final List<JointWatch> jointWatches = new ArrayList<>();

    /** The names of columns that the text defines. */
    private final Map<String, Span> defined = new LinkedHashMap<>();

    private @Nullable WatchBlock open;
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
            parser.read(line);
        }
        return parser.result();
    }

    /**
     * The words of which one may follow.
     *
     * @param beginning of a text, up to the end of a word
     */
    public static List<String> choicesAfter(SourceFile beginning) {
        CampaignParser parser = new CampaignParser(beginning);
        int last = beginning.lineCount();
        for (int line = 1; line < last; line++) {
            parser.read(line);
        }
        return parser.read(last);
    }

    /** The words of which one is missing at its end. */
    private List<String> read(int line) {
        Words words = Words.ofLine(file, line, SYNTAX);
        if (words.isEmpty()) {
            return STATEMENTS;
        }
        try {
            if (open == null || !continued(open, words)) {
                statement(words, words.choice("what a campaign says", STATEMENTS));
            }
            words.end();
            return List.of();
        } catch (Unreadable e) {
            findings.add(e.finding());
            return e.choices();
        }
    }

    /** Whether a line belongs to the watch that is open; a statement does not, and closes it. */
    private boolean continued(WatchBlock block, Words words) throws Unreadable {
        if (WatchBlock.isClosedBy(words)) {
            open = null;
            define(block.watch());
            return true;
        }
        if (STATEMENTS.contains(words.first().text()) && !words.isSecond("=")) {
            requireClosed();
            return false;
        }
        block.read(words);
        return true;
    }

    private void requireClosed() {
        if (open != null) {
            findings.add(
                    Diagnostic.error(
                            SYNTAX,
                            open.place(),
                            "this is not closed: write '}' on a line behind its ports"));
            open = null;
        }
    }

    private void statement(Words words, Word what) throws Unreadable {
        switch (what.text()) {
            case "vary" -> vary(words);
            case "measure" -> define(Measure.number(words));
            case "event" -> define(Measure.event(words));
            case "watch" -> watch(words);
            case "require" -> demands.add(phrases().demand(words));
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
            case "sample" -> plan = CampaignPhrases.plan(words);
            case "seeds" -> {
                words.expect("from");
                firstSeed = words.count("the first seed", 0, CampaignPhrases.MOST);
            }
            case "stop" -> {
                words.expect("decided");
                stopsWhenDecided = true;
            }
            case "compare" -> comparison = phrases().comparison(words);
            case "worst" -> search = phrases().search(words);
            default -> split = CampaignPhrases.split(words);
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
        measures.add(measure);
    }

    private void watch(Words words) throws Unreadable {
        Watched watched = Watched.of(words);
        if (WatchBlock.isOpened(watched)) {
            open = WatchBlock.of(watched, words);
        } else {
            requireColumn(watched.name(), watched.place());
            watches.add(watched);
        }
    }

    private void define(JointWatch watch) throws Unreadable {
        requireColumn(watch.name(), watch.place());
        jointWatches.add(watch);
    }

    private void requireColumn(String name, Span place) throws Unreadable {
        unique("column " + name, place);
        defined.put(name, place);
        boolean taken =
                Quantity.words(true).contains(name)
                        || Quantity.words(false).contains(name)
                        || TableText.NAMES.contains(name);
        if (taken) {
            throw new Unreadable(
                    Diagnostic.error(TWICE, place, "every table has a column '" + name + "'"));
        }
    }

    private CampaignPhrases phrases() {
        return new CampaignPhrases(columns(true), columns(false));
    }

    /** The columns that the text has named so far, and those that every table has. */
    private List<String> columns(boolean event) {
        List<String> names = new ArrayList<>(Quantity.words(event));
        measures.stream()
                .filter(each -> each.fold().isEvent() == event)
                .forEach(each -> names.add(each.name()));
        if (event) {
            watches.forEach(each -> names.add(each.name()));
            jointWatches.forEach(each -> names.add(each.name()));
        }
        return names;
    }

    private void vary(Words words) throws Unreadable {
        Word name = words.next("the name of a parameter of the world");
        unique("vary " + name.text(), name.place());
        Domain domain = CampaignPhrases.domain(words);
        variations.put(name.text(), new Variation(name.text(), domain, name.place()));
    }

    private Reading result() {
        requireClosed();
        requireThere(world != null, "a world: write 'world FILE'");
        requireThere(plan != null, "a number of runs: write 'sample random N'");
        if (findings.isEmpty()) {
            checkColumns();
            checkComparison();
            checkSearch();
            checkStop();
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
                measures,
                watches,
                jointWatches,
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
        defined.forEach(this::requireNoParameter);
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

    /** Who looks after each run needs runs that are independent, and all of one kind. */
    private void checkStop() {
        Span place = once.get("stop");
        boolean grid = plan != null && plan.match(random -> false, latin -> false, all -> true);
        if (place != null && (grid || comparison != null)) {
            String why =
                    grid
                            ? "the points of a grid are tried all: 'stop decided' goes with 'sample"
                                    + " random'"
                            : "a comparison takes all of its pairs: leave out 'stop decided'";
            findings.add(Diagnostic.error(MEANINGLESS, place, why));
        }
    }

    private void checkSplit(Split asked) {
        asked.columns().stream()
                .filter(name -> defined.containsKey(name) || variations.containsKey(name))
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
