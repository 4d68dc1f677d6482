package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.sim.load.Program;
import arcomat.sim.load.ProgramException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;

/** Programs come as jars. */
class LoadTest {
    private static final Program HELLO = Compiled.main("System.out.println(\"hello\");");

    @TempDir private Path folder;

    private Path jar(String mainClass, Map<String, byte[]> classes) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        if (mainClass != null) {
            manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, mainClass);
        }
        Path file = folder.resolve("robot.jar");
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file), manifest)) {
            for (Map.Entry<String, byte[]> entry : classes.entrySet()) {
                jar.putNextEntry(new JarEntry(entry.getKey().replace('.', '/') + ".class"));
                jar.write(entry.getValue());
            }
        }
        return file;
    }

    @Test
    void aJarRunsFromItsMainClass() throws IOException, ProgramException {
        Program program = Program.read(jar("Main", HELLO.classes()));
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("brick", program);
            laboratory.runToEnd(1000);
            assertThat(brick.screen().get(0)).isEqualTo("hello");
        }
    }

    @Test
    void noProgramBringsClassesOfTheSimulation() {
        for (String name : List.of("arcomat.sim.Outcome", "lejos.nxt.LCD", "java.lang.Own")) {
            Program program =
                    new Program(
                            "Main", Map.of("Main", HELLO.classes().get("Main"), name, new byte[0]));
            try (Laboratory laboratory = new Laboratory()) {
                assertThatThrownBy(() -> laboratory.place("brick", program))
                        .isInstanceOf(IllegalArgumentException.class)
                        .hasMessageContaining(name);
            }
        }
    }

    @Test
    void aJarWithoutMainClassIsNoProgram() throws IOException {
        Path jar = jar(null, HELLO.classes());
        assertThatThrownBy(() -> Program.read(jar))
                .isInstanceOf(ProgramException.class)
                .hasMessageContaining("has no Main-Class");
    }

    @Test
    void aJarThatLacksItsMainClassIsNoProgram() throws IOException {
        Path jar = jar("Other", HELLO.classes());
        assertThatThrownBy(() -> Program.read(jar))
                .isInstanceOf(ProgramException.class)
                .hasMessageContaining("names the main class Other but does not contain it");
    }
}
