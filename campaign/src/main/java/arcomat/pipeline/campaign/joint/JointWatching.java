package arcomat.pipeline.campaign.joint;

import arcomat.campaign.Campaign;
import arcomat.campaign.JointWatch;
import arcomat.pipeline.campaign.measure.MeasuredExpression;
import arcomat.pipeline.campaign.measure.Vocabulary;
import arcomat.pipeline.compile.ClassesInMemory;
import arcomat.pipeline.world.Onlooker;
import arcomat.sim.load.Probe;
import arcomat.source.SourceFile;
import arcomat.world.World;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The requirements of a campaign on several robots, ready to be watched in any of its worlds. */
public final class JointWatching {
    private final JointFreight freight;
    private final ClassLoader classes;
    private final List<Prepared> requirements = new ArrayList<>();

    /**
     * A requirement with what its ports are bound to.
     *
     * @param expressions by the names of ports
     */
    record Prepared(
            JointWatch watch,
            JointRequirement requirement,
            Map<String, MeasuredExpression> expressions) {}

    private JointWatching(JointFreight freight) {
        this.freight = freight;
        this.classes = new ClassesInMemory(freight.classes());
    }

    /**
     * @param world text of the world, with its parameters
     */
    public static JointWatching of(JointFreight freight, Campaign campaign, SourceFile world) {
        JointWatching watching = new JointWatching(freight);
        if (!freight.requirements().isEmpty()) {
            Vocabulary vocabulary = Vocabulary.of(campaign, world);
            for (int i = 0; i < freight.requirements().size(); i++) {
                JointRequirement requirement = freight.requirements().get(i);
                JointWatch watch = campaign.jointWatches().get(i);
                watching.requirements.add(
                        new Prepared(
                                watch, requirement, expressions(watch, requirement, vocabulary)));
            }
        }
        return watching;
    }

    private static Map<String, MeasuredExpression> expressions(
            JointWatch watch, JointRequirement requirement, Vocabulary vocabulary) {
        Map<String, String> types = new LinkedHashMap<>();
        requirement.ports().forEach(port -> types.put(port.name(), port.type()));
        Map<String, MeasuredExpression> expressions = new LinkedHashMap<>();
        for (JointWatch.Binding each : watch.bindings()) {
            if (each.robotPort().isEmpty()) {
                String type = types.getOrDefault(each.port(), "");
                MeasuredExpression.read(each.source(), type, vocabulary)
                        .expression()
                        .ifPresent(read -> expressions.put(each.port(), read));
            }
        }
        return expressions;
    }

    /** Where a program tells of its slices; nowhere, if nobody asks. */
    public List<Probe> probes(String program) {
        return Optional.ofNullable(freight.programs().get(program)).stream()
                .map(ProgramTaps::probe)
                .toList();
    }

    /** In one world; any number of runs may be watched at once. */
    public InWorld in(World world) {
        return new InWorld(world);
    }

    /** All requirements, in a world. */
    public final class InWorld {
        private final Map<String, ProgramTaps> robots = new LinkedHashMap<>();
        private final List<JointQuestion> questions = new ArrayList<>();

        private InWorld(World world) {
            for (World.Robot robot : world.robots()) {
                ProgramTaps taps = freight.programs().get(robot.kind().program().key());
                if (taps != null) {
                    robots.put(robot.name(), taps);
                }
            }
            requirements.forEach(each -> questions.add(JointQuestion.of(each, world, robots)));
        }

        /**
         * Before a run.
         *
         * @param beside sees the same
         */
        public JointRun start(Onlooker beside) {
            return new JointRun(robots, questions, classes, beside);
        }
    }
}
