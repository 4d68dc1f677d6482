package arcomat.gradle;

import java.io.File;

/**
 * The files through which a worker process tells what came of a command.
 *
 * @param number of the command among those of its task
 */
record ToolOutput(File folder, int number) {
    File out() {
        return file("out");
    }

    File err() {
        return file("err");
    }

    File status() {
        return file("status");
    }

    ToolResult result() {
        return new ToolResult(
                Integer.parseInt(Texts.read(status())), Texts.read(out()), Texts.read(err()));
    }

    private File file(String what) {
        return new File(folder, what + number + ".txt");
    }
}
