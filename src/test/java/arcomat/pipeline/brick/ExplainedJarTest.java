package arcomat.pipeline.brick;

import static arcomat.report.ShownTracks.texts;
import static arcomat.report.ShownTracks.track;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Trace;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.report.brick.BrickPage;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Drawing;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.RobotRun;
import arcomat.simulate.run.Simulation;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** What goes on inside of a program that runs from its jar, told by the models it was made of. */
class ExplainedJarTest {
    private static final JarModels COFFEE =
            new JarModels(List.of("models/coffee"), Optional.empty());

    @TempDir private Path folder;

    private RunJar.Run run(Optional<JarModels> models) throws Exception {
        byte[] bytes = CoffeeRobot.of("coffee.fetcher.Fetcher").jar();
        String jar = Files.write(folder.resolve("Fetcher.jar"), bytes).toString();
        RunJar task =
                new RunJar(
                        jar,
                        Optional.of("models/coffee/scripts/fetcher.script"),
                        Map.of(),
                        OptionalInt.empty(),
                        Laboratory.PATIENCE,
                        Limits.OF_THE_BRICK,
                        models);
        return Session.in(Path.of(""), Progress.NONE).run(task).run().orElseThrow();
    }

    @Test
    void whoeverAsksTheRunIsTheSame() throws Exception {
        RunJar.Run plain = run(Optional.empty());
        RunJar.Run asked = run(Optional.of(COFFEE));
        assertThat(plain.inside()).isEmpty();
        assertThat(asked.trace()).isEqualTo(plain.trace());
        assertThat(asked.milliseconds()).isEqualTo(plain.milliseconds());
        assertThat(asked.lateness()).isEqualTo(plain.lateness());
        assertThat(asked.screen()).isEqualTo(plain.screen());
    }

    @Test
    void theInterpreterDoesTheSame() throws Exception {
        RobotRun inside = run(Optional.of(COFFEE)).inside().orElseThrow();
        Trace told = inside.trace();
        assertThat(told.steps()).hasSizeGreaterThan(40);
        Interpreter interpreter =
                new Interpreter(told.component(), List.of(), Choice.first()).explaining();
        assertThat(Simulation.run(interpreter, told.received()).steps()).isEqualTo(told.steps());
    }

    /** The program runs for 41 slices, and tidies up in the three cycles behind them. */
    @Test
    void thePageHasAllAtTheSameCycle() throws Exception {
        RunJar.Run run = run(Optional.of(COFFEE));
        Story story =
                BrickPage.of(
                                "Fetcher.jar",
                                run.trace(),
                                run.ending(),
                                run.failure(),
                                run.lateness(),
                                run.screen(),
                                run.inside())
                        .stories()
                        .get(0);
        int length = story.timeline().length();
        assertThat(length).isEqualTo(44);
        assertThat(story.timeline().tracks())
                .allSatisfy(track -> assertThat(texts(track)).hasSize(length));
        List<String> sensor = texts(track(story, "sensor S1"));
        List<String> input = texts(track(story, "ultrasonic.distance"));
        assertThat(input.subList(0, 41)).isEqualTo(sensor.subList(0, 41));
        assertThat(input.subList(41, length)).containsOnly("-");
        assertThat(texts(track(story, "avoidCrash")).subList(4, 7))
                .containsExactly("driving", "backing", "backing");
        assertThat(texts(track(story, "avoidCrash")).subList(40, length)).containsOnly("driving");
        assertThat(story.drawings())
                .extracting(Drawing::title)
                .startsWith("coffee.fetcher.Fetcher")
                .contains("avoidCrash", "drive");
    }
}
