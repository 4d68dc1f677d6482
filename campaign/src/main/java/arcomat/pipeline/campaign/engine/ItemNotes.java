package arcomat.pipeline.campaign.engine;

import arcomat.campaign.coverage.ReachedItems;
import arcomat.pipeline.compile.Slot;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.sim.device.LineNotes;
import arcomat.world.Scene;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What the robots of one run have covered, all together and part by part. */
final class ItemNotes implements Onlooker {
    /** By the names of robots, of those whose programs were made of models. */
    private final Map<String, ProgramItems> programs = new LinkedHashMap<>();

    private final Onlooker beside;
    private final BitSet numbers = new BitSet();

    /**
     * @param beside sees the same
     */
    ItemNotes(ItemProbes probes, World world, Onlooker beside) {
        world.robots()
                .forEach(
                        robot ->
                                probes.of(robot.kind().program().key())
                                        .ifPresent(each -> programs.put(robot.name(), each)));
        this.beside = beside;
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        beside.see(scene, instruments);
    }

    @Override
    public void entered(String robot, Object object, String method) {
        beside.entered(robot, object, method);
    }

    @Override
    public void left(String robot, Object object, String method) {
        beside.left(robot, object, method);
    }

    @Override
    public void noted(String robot, List<LineNotes> notes) {
        beside.noted(robot, notes);
        ProgramItems program = programs.get(robot);
        if (program != null) {
            new OneProgram(program, notes).add(robot);
        }
    }

    /** Not known where no program of the world was made of models. */
    ReachedItems reached() {
        return programs.isEmpty() ? ReachedItems.UNKNOWN : ReachedItems.of(numbers);
    }

    /** What the objects of a robot's program have noted. */
    private final class OneProgram {
        private final ProgramItems program;
        private final Map<Object, BitSet> notes = new IdentityHashMap<>();
        private @Nullable Object whole;

        OneProgram(ProgramItems program, List<LineNotes> all) {
            this.program = program;
            for (LineNotes each : all) {
                notes.put(each.object(), each.numbers());
                if (isOf(program.whole(), each.object())) {
                    whole = each.object();
                }
            }
        }

        /** Parts of event-driven networks are of classes of their own, below that of the model. */
        private static boolean isOf(String type, Object object) {
            Class<?> each = object.getClass();
            while (each != null && !each.getName().equals(type)) {
                each = each.getSuperclass();
            }
            return each != null;
        }

        void add(String robot) {
            notes.forEach(this::addToAutomaton);
            for (ProgramItems.OfPart part : program.parts()) {
                if (part.robot().equals(robot)) {
                    addToPart(part);
                }
            }
        }

        private void addToAutomaton(Object object, BitSet noted) {
            if (noted.isEmpty()) {
                return;
            }
            for (ProgramItems.OfClass each : program.automata()) {
                if (isOf(each.lines().type(), object)) {
                    noted.stream().map(each::number).forEach(numbers::set);
                }
            }
        }

        /** A program that has failed at its beginning need not have all of its parts. */
        private void addToPart(ProgramItems.OfPart part) {
            BitSet noted = notes.get(object(part.fields()));
            if (noted != null) {
                noted.stream().map(each -> part.first() + each).forEach(numbers::set);
            }
        }

        private @Nullable Object object(String fields) {
            return whole == null || fields.isEmpty() ? whole : Slot.reach(whole, fields);
        }
    }
}
