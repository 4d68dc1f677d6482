package arcomat.live;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;

/** Worlds on the page: what is found in them, and what keeps one from running there. */
class OpenWorldsTest {
    private static final String WORLD =
            """
            floor 2000 1000
            seconds 3
            kind rover
              program component Rover in .
              body 80 900
              wheels A B
              ultrasonic S1 at 75 0
            robot one rover at 300 500
            """;

    private static final String ROVER =
            """
            import nxt.*;
            import nxt.Brick.*;

            <<deploy>> component Rover {
                component UltrasonicSensor(SensorPort.S1) eye;
                component Mind mind;
                component RegulatedMotor(MotorPort.A) left;
                component RegulatedMotor(MotorPort.B) right;
                component LcdLogger(0) display;
                connect eye.distance -> mind.distance;
                connect mind.speed -> left.speed, right.speed;
                connect mind.doing -> display.text;

                component Mind {
                    timing instant;
                    port <<total>> in Integer[0..255] distance, out Integer speed, out String doing;
                    <<completion = "ignore">> automaton {
                        state standing, driving;
                        initial standing;
                        standing -> driving [distance > 40] / {speed = 360, doing = "driving"};
                        driving -> standing [distance <= 20] / {speed = 0, doing = "standing"};
                    }
                }
            }
            """;

    private final Desk desk = new Desk();

    private String check(String world, String rover) throws IOException {
        return ModelTexts.check(desk, texts(world, rover));
    }

    private static Map<String, String> texts(String world, String rover) throws IOException {
        Map<String, String> texts = new TreeMap<>(ModelTexts.library());
        texts.put("Rover.arc", rover);
        texts.put("yard.world", world);
        return texts;
    }

    /** As editors have it: words of the language, names of the world, components, their folder. */
    @Test
    void offersWhatCouldBeWritten() throws IOException {
        check(WORLD, ROVER);
        assertThat(offered("robot one rover")).contains("\"label\":\"rover\"", "kind of robots");
        assertThat(offered("program component Rover"))
                .contains("\"label\":\"Rover\"")
                .doesNotContain("\"label\":\"Mind\"");
        assertThat(offered("program component Rover in ."))
                .contains("\"from\":66,", "\"label\":\"..\"", "folder of models");
        assertThat(offered("ultrasonic")).contains("\"words\":[", "\"holder\"", "\"bumper\"");
        assertThat(desk.complete("robots/empty.world", "", 0))
                .contains("\"floor\"", "a world with one robot", "${1:2000}");
    }

    /** In front of the last word of some text. */
    private String offered(String words) {
        String before = words.stripTrailing();
        int at = WORLD.indexOf(before) + before.lastIndexOf(' ') + 1;
        return desk.complete("robots/room.world", WORLD, at);
    }

    @Test
    void aRunIsWhatPagesOfWorldsPlay() throws IOException {
        assertThat(check(WORLD, ROVER)).contains("\"findings\":[]");
        assertThat(desk.floor("yard.world", 1))
                .contains("\"headline\":\"3.0 s, no collision\"")
                .contains("\"who\":\"one\",\"text\":\"driving\"");
    }

    /** As in an editor; models are no obstacle to worlds, nor the other way round. */
    @Test
    void findingsAboutAWorldStandAmongTheOthers() throws IOException {
        assertThat(check(WORLD.replace("body 80 900", "body 80"), ROVER))
                .contains("\"path\":\"yard.world\",\"line\":5")
                .contains("\"code\":\"ARC1121\"")
                .contains("\"whole\":true");
        assertThat(desk.floor("yard.world", 1)).contains("there are errors in the world");
    }

    @Test
    void whatIsWrittenAnewIsRun() throws IOException {
        check(WORLD, ROVER);
        desk.floor("yard.world", 1);
        check(WORLD, ROVER.replace("\"driving\"", "\"rolling\""));
        assertThat(desk.floor("yard.world", 1)).contains("rolling").doesNotContain("driving");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "component Rover in . | jar build/Rover.jar |"
                        + " 'build/Rover.jar' is a jar, and here only models run",
                "component Rover in . | component Rower in . |"
                        + " there is no component 'Rower'; did you mean 'Rover'?",
                "component Rover in . | component Rover.Mind in . | has no parts",
                "ultrasonic S1 at 75 0 | device S1 Eye.java | the device 'Eye.java'",
            })
    void whatCannotRunIsNamed(String here, String instead, String told) throws IOException {
        check(WORLD.replace(here, instead), ROVER);
        assertThat(desk.floor("yard.world", 1)).contains("\"refused\":\"").contains(told);
    }

    @Test
    void whatOnlyJavaTellsIsNamed() throws IOException {
        String own =
                "<<platform, layer = \"actuators\">> component Horn { port in Integer tone; }\n";
        String horn =
                ROVER.replace("component Mind mind;", "component Mind mind;\n component Horn horn;")
                        .replace("-> left.speed,", "-> horn.tone, left.speed,");
        Map<String, String> texts = texts(WORLD, horn);
        texts.put("Horn.arc", own);
        ModelTexts.check(desk, texts);
        assertThat(desk.floor("yard.world", 1))
                .contains("'Rover' needs Horn, and only Java says what that does");
    }
}
