package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Variation;
import arcomat.campaign.Variation.Choice;
import arcomat.campaign.Variation.Range;
import arcomat.generate.CodeLayout;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.PluggedDevices;
import arcomat.pipeline.campaign.watch.CampaignCode;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.pipeline.world.ProgramCache;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Kind;
import arcomat.world.World;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * The programs of all runs of a campaign, made before the first of them: those of every word that a
 * parameter can have. A number that changes a program has to be named as a word is: there would be
 * no end of programs.
 */
final class CampaignPrograms {
    private static final String UNKNOWN = "ARC1133";
    private static final String ENDLESS = "ARC1134";
    static final String NO_WORLD = "ARC1135";

    private static final String STRANGER =
            "a campaign runs no device in Java: who makes its runs may be another machine, whose"
                    + " owner has not read it; 'arcomat world --run-devices' runs this world once";

    /** Each is a world to be read; making a program takes a second. */
    private static final int MOST = 10_000;

    /** So many numbers are looked at one by one, as words are. */
    private static final int COUNTED = 50;

    /** No middle of anything, so that no end looks like it. */
    private static final double BETWEEN = 0.37;

    private final Campaign campaign;
    private final SourceFile text;
    private final String file;
    private final TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
    private final Map<String, Program> programs = new TreeMap<>();
    private final Map<String, CodeLayout> layouts = new TreeMap<>();
    private final Map<String, Set<String>> robots = new TreeMap<>();
    private final ProgramCache made = new ProgramCache();
    private final Map<String, Kind.Program> named = new TreeMap<>();
    private Aside aside = Aside.NOTHING;
    private int files = 1;

    private CampaignPrograms(Campaign campaign, SourceFile text, String file) {
        this.campaign = campaign;
        this.text = text;
        this.file = file;
    }

    /**
     * What came of it.
     *
     * @param code the programs
     * @param findings about the campaign, the world and models
     * @param files how many files were read
     * @param aside models that programs are made without
     */
    record Result(CampaignCode code, List<Diagnostic> findings, int files, Aside aside) {}

    /**
     * @param file of the world, as the user would write it
     */
    static Result of(Campaign campaign, SourceFile text, String file, Session session)
            throws WrongUse {
        CampaignPrograms all = new CampaignPrograms(campaign, text, file);
        all.requireParameters();
        if (all.findings.isEmpty()) {
            all.make(session);
        }
        return new Result(
                new CampaignCode(all.named, all.robots, all.programs, all.layouts),
                List.copyOf(all.findings),
                all.files,
                all.aside);
    }

    private void requireParameters() {
        findings.addAll(unknownParameters(campaign, text, file));
    }

    /** About those that a campaign varies and its world does not have. */
    static List<Diagnostic> unknownParameters(Campaign campaign, SourceFile text, String file) {
        List<Diagnostic> findings = new ArrayList<>();
        List<String> known =
                WorldParser.parameters(text).stream().map(WorldParameter::name).toList();
        for (Variation each : campaign.variations()) {
            if (!known.contains(each.parameter())) {
                String there = known.isEmpty() ? "none" : String.join(", ", known);
                findings.add(
                        Diagnostic.error(
                                UNKNOWN,
                                each.place(),
                                "'%s' has no parameter '%s'; it has %s"
                                        .formatted(file, each.parameter(), there)));
            }
        }
        return findings;
    }

    private void make(Session session) throws WrongUse {
        List<Map<String, String>> combinations = combinations();
        Map<String, Map<String, String>> wanted = wanted(combinations);
        if (wanted.isEmpty() && findings.isEmpty()) {
            tellNoWorld(combinations.get(0));
        }
        requireEnd(combinations, wanted.keySet());
        for (Map.Entry<String, Map<String, String>> each : wanted.entrySet()) {
            if (findings.stream().noneMatch(Diagnostic::isError)
                    && !programs.containsKey(each.getKey())) {
                prepare(each.getValue(), session);
            }
        }
    }

    /** What is wrong with the world itself is most likely wrong with the first values. */
    private void tellNoWorld(Map<String, String> values) {
        findings.add(
                Diagnostic.error(
                        NO_WORLD,
                        campaign.world().place(),
                        "'%s' is no world with any of these values".formatted(file)));
        findings.addAll(WorldParser.parse(text, values).findings());
    }

    /** Every program that is named somewhere, with values that name it. */
    private Map<String, Map<String, String>> wanted(List<Map<String, String>> combinations) {
        Map<String, Map<String, String>> wanted = new LinkedHashMap<>();
        for (Map<String, String> values : combinations) {
            programsOf(values)
                    .forEach(
                            (key, program) -> {
                                named.put(key, program);
                                wanted.putIfAbsent(key, values);
                            });
        }
        return wanted;
    }

    private void prepare(Map<String, String> values, Session session) throws WrongUse {
        PreparedWorld world = new PrepareWorld(file, false, values).of(text, session, made);
        aside = aside.and(world.aside());
        files = Math.max(files, world.files());
        findings.addAll(world.findings());
        programs.putAll(world.programs());
        layouts.putAll(world.layouts());
    }

    /** What a world with these values names; nothing, where it is no world. */
    private Map<String, Kind.Program> programsOf(Map<String, String> values) {
        Map<String, Kind.Program> all = new TreeMap<>();
        WorldParser.parse(text, values)
                .world()
                .ifPresent(world -> world.robots().forEach(robot -> add(robot, all)));
        return all;
    }

    private void add(World.Robot robot, Map<String, Kind.Program> all) {
        Kind.Program program = robot.kind().program();
        all.put(program.key(), program);
        robots.computeIfAbsent(robot.name(), name -> new TreeSet<>()).add(program.key());
        robot.kind().described().stream()
                .filter(Kind.Described::isProgram)
                .forEach(each -> findings.add(each.error(PluggedDevices.NO_DEVICE, STRANGER)));
    }

    /** A number that is a program's argument names another program between its ends. */
    private void requireEnd(List<Map<String, String>> combinations, Set<String> wanted) {
        for (Map<String, String> values : combinations) {
            for (Variation each : campaign.variations()) {
                if (each.domain() instanceof Range range && !isCounted(range)) {
                    Map<String, String> between = new LinkedHashMap<>(values);
                    between.put(each.parameter(), range.at(BETWEEN));
                    if (!wanted.containsAll(programsOf(between).keySet())) {
                        findings.add(endless(each));
                    }
                }
            }
        }
    }

    private static Diagnostic endless(Variation each) {
        String name = each.parameter();
        String message =
                "each value of '%s' is a program of its own: name those that are wanted, 'vary %s"
                        + " of VALUE VALUE'";
        return Diagnostic.error(ENDLESS, each.place(), message.formatted(name, name));
    }

    /** Every word with every other, and with the ends of numbers. */
    private List<Map<String, String>> combinations() {
        List<Map<String, String>> all = new ArrayList<>();
        all.add(new LinkedHashMap<>());
        for (Variation each : campaign.variations()) {
            List<Map<String, String>> more = new ArrayList<>();
            for (Map<String, String> values : all) {
                for (String word : each.domain().match(CampaignPrograms::ends, Choice::words)) {
                    Map<String, String> longer = new LinkedHashMap<>(values);
                    longer.put(each.parameter(), word);
                    more.add(longer);
                }
            }
            if (more.size() > MOST) {
                findings.add(
                        Diagnostic.error(
                                ENDLESS,
                                each.place(),
                                "these are more than %,d combinations of words".formatted(MOST)));
                return List.of();
            }
            all = more;
        }
        return all;
    }

    private static boolean isCounted(Range range) {
        return range.whole() && range.high() - range.low() < COUNTED;
    }

    private static List<String> ends(Range range) {
        if (!isCounted(range)) {
            return List.of(range.at(0), range.at(1));
        }
        int numbers = (int) (range.high() - range.low()) + 1;
        return IntStream.range(0, numbers).mapToObj(i -> range.at((i + 0.5) / numbers)).toList();
    }
}
