package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.sim.device.LineNotes;
import arcomat.world.Scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** One run that is watched for what several robots do. */
public final class JointRun implements Onlooker {
    private final Map<String, ShownSlices> robots = new LinkedHashMap<>();
    private final List<RequirementRun> requirements = new ArrayList<>();
    private final Onlooker beside;

    JointRun(
            Map<String, ProgramTaps> programs,
            List<JointQuestion> questions,
            ClassLoader classes,
            Onlooker beside) {
        programs.forEach((robot, taps) -> robots.put(robot, new ShownSlices(taps)));
        questions.forEach(each -> requirements.add(new RequirementRun(each, robots, classes)));
        this.beside = beside;
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        beside.see(scene, instruments);
        WorldMoment moment = new WorldMoment(robots, scene, instruments);
        requirements.forEach(each -> each.see(moment));
        robots.values().forEach(ShownSlices::forget);
    }

    @Override
    public void entered(String robot, Object object, String method) {
        beside.entered(robot, object, method);
        ShownSlices slices = robots.get(robot);
        if (slices != null) {
            slices.entered(object, method);
        }
    }

    @Override
    public void left(String robot, Object object, String method) {
        beside.left(robot, object, method);
        ShownSlices slices = robots.get(robot);
        if (slices != null) {
            slices.left(object, method);
        }
    }

    @Override
    public void noted(String robot, List<LineNotes> notes) {
        beside.noted(robot, notes);
    }

    /** The run is over, and so is what was left open. */
    public void end() {
        requirements.forEach(RequirementRun::end);
    }

    /** One for each column: 1 where its requirement was violated; not a number where unknown. */
    public List<Double> answers() {
        return requirements.stream().map(RequirementRun::answer).toList();
    }

    /** Why it cannot be told whether something was violated. */
    public Optional<String> doubt() {
        return requirements.stream().flatMap(each -> each.doubt().stream()).findFirst();
    }
}
