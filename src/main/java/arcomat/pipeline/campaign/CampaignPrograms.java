package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Variation;
import arcomat.campaign.Variation.Choice;
import arcomat.campaign.Variation.Range;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
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
import java.util.stream.Collectors;

/**
 * The programs of all runs of a campaign, made before the first of them: those of every word that a
 * parameter can have. A number that changes a program has to be among words, too: there would be no
 * end of programs.
 */
final class CampaignPrograms {
    private static final String UNKNOWN = "ARC1133";
    private static final String ENDLESS = "ARC1134";
    private static final String NO_WORLD = "ARC1135";

    /** Making a program takes a second. */
    private static final int MOST = 500;

    private final Campaign campaign;
    private final SourceFile text;
    private final String file;
    private final TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
    private final Map<String, Program> programs = new TreeMap<>();
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
     * @param programs by what worlds say of them
     * @param findings about the campaign, the world and models
     * @param files how many files were read
     * @param aside models that programs are made without
     */
    record Result(
            Map<String, Program> programs, List<Diagnostic> findings, int files, Aside aside) {}

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
        return new Result(all.programs, List.copyOf(all.findings), all.files, all.aside);
    }

    private void requireParameters() {
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
    }

    private void make(Session session) throws WrongUse {
        for (Map<String, String> values : combinations()) {
            Set<String> wanted = programsOf(values);
            requireNoEnd(values, wanted);
            if (findings.stream().noneMatch(Diagnostic::isError)
                    && !programs.keySet().containsAll(wanted)) {
                prepare(values, session);
            }
        }
        if (programs.isEmpty() && findings.isEmpty()) {
            findings.add(
                    Diagnostic.error(
                            NO_WORLD,
                            campaign.world().place(),
                            "'%s' is no world with any of these values".formatted(file)));
        }
    }

    private void prepare(Map<String, String> values, Session session) throws WrongUse {
        PreparedWorld world = session.run(new PrepareWorld(file, false, values));
        aside = aside.and(world.aside());
        files = Math.max(files, world.files());
        findings.addAll(world.findings());
        programs.putAll(world.programs());
    }

    /** What a world with these values names; nothing, where it is no world. */
    private Set<String> programsOf(Map<String, String> values) {
        return WorldParser.parse(text, values).world().stream()
                .flatMap(world -> world.robots().stream())
                .map(World.Robot::kind)
                .map(kind -> kind.program().key())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private void requireNoEnd(Map<String, String> values, Set<String> wanted) {
        for (Variation each : campaign.variations()) {
            if (each.domain() instanceof Range) {
                Map<String, String> other = new LinkedHashMap<>(values);
                other.put(each.parameter(), each.domain().at(1));
                Set<String> then = programsOf(other);
                if (!then.isEmpty() && !wanted.isEmpty() && !then.equals(wanted)) {
                    findings.add(
                            Diagnostic.error(
                                    ENDLESS,
                                    each.place(),
                                    "each value of '%s' is a program of its own: name those that"
                                            + " are wanted, 'vary %s of VALUE VALUE'"
                                                    .formatted(
                                                            each.parameter(), each.parameter())));
                }
            }
        }
    }

    /** Every word with every other; numbers, which change no program, are the least. */
    private List<Map<String, String>> combinations() {
        List<Map<String, String>> all = new ArrayList<>();
        all.add(new LinkedHashMap<>());
        for (Variation each : campaign.variations()) {
            List<String> words =
                    each.domain().match(range -> List.of(range.at(0)), Choice::words);
            List<Map<String, String>> more = new ArrayList<>();
            for (Map<String, String> values : all) {
                for (String word : words) {
                    Map<String, String> longer = new LinkedHashMap<>(values);
                    longer.put(each.parameter(), word);
                    more.add(longer);
                }
            }
            all = more.size() > MOST ? more.subList(0, MOST) : more;
        }
        return all;
    }
}
