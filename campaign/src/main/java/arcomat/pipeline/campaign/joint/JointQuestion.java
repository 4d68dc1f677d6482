package arcomat.pipeline.campaign.joint;

import arcomat.campaign.JointWatch;
import arcomat.campaign.JointWatch.RobotPort;
import arcomat.pipeline.campaign.joint.JointRequirement.WatchedPort;
import arcomat.pipeline.campaign.measure.MeasuredExpression;
import arcomat.world.World;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A requirement in a world.
 *
 * @param sources one for each of its ports, if the world has all that they are bound to
 * @param isWhole whether it has
 */
record JointQuestion(JointRequirement requirement, List<PortSource> sources, boolean isWhole) {
    static JointQuestion of(
            JointWatching.Prepared prepared, World world, Map<String, ProgramTaps> robots) {
        List<PortSource> sources = new ArrayList<>();
        boolean isWhole = true;
        for (WatchedPort port : prepared.requirement().ports()) {
            MeasuredExpression expression = prepared.expressions().get(port.name());
            Optional<PortSource> source =
                    expression == null
                            ? PortSource.of(robotPort(prepared.watch(), port.name()), robots)
                            : PortSource.of(expression, world);
            source.ifPresent(sources::add);
            isWhole &= source.isPresent();
        }
        return new JointQuestion(prepared.requirement(), isWhole ? sources : List.of(), isWhole);
    }

    private static RobotPort robotPort(JointWatch watch, String port) {
        return watch.bindings().stream()
                .filter(each -> each.port().equals(port))
                .flatMap(each -> each.robotPort().stream())
                .findFirst()
                .orElseThrow();
    }
}
