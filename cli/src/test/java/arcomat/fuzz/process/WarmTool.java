package arcomat.fuzz.process;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A process with the jars of the installation that runs many calls, through the same door as the
 * start script but for the process around it: a call costs what its work costs. It is started anew
 * after a call that did not come back, or gave up and may have left a thread behind.
 */
final class WarmTool implements Tool {
    private static final int UNKNOWN = 3;

    /** Then it starts anew, so that nothing piles up in it. */
    private static final int MOST_CALLS = 1000;

    private final Path temporary;
    private final Path errors;
    private final ExecutorService reader =
            Executors.newSingleThreadExecutor(
                    work -> {
                        Thread thread = new Thread(work, "answers");
                        thread.setDaemon(true);
                        return thread;
                    });
    private Process process;
    private DataOutputStream calls;
    private DataInputStream answers;
    private int called;

    /**
     * @param temporary the folder for temporary files of all calls
     * @param errors a file for what the process says of itself
     */
    WarmTool(Path temporary, Path errors) {
        this.temporary = temporary;
        this.errors = errors;
    }

    @Override
    public Outcome run(Sandbox sandbox, Call call) throws IOException, InterruptedException {
        if (process == null || !process.isAlive() || called++ == MOST_CALLS) {
            start();
        }
        send(sandbox, call);
        Future<Outcome> answer = reader.submit(this::receive);
        try {
            Outcome outcome = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            if (outcome.status().equals(Optional.of(UNKNOWN))) {
                close();
            }
            return outcome;
        } catch (TimeoutException hangs) {
            String threads = threads();
            close();
            answer.cancel(true);
            return new Outcome(Optional.empty(), "", "", threads, PATIENCE_SECONDS);
        } catch (ExecutionException died) {
            close();
            if (!(died.getCause() instanceof EOFException)) {
                throw new IOException(died.getCause());
            }
            return new Outcome(Optional.empty(), "", "", "died\n" + Files.readString(errors), 0);
        }
    }

    private void start() throws IOException {
        close();
        String classes =
                Stream.concat(
                                Installation.libraries().stream().map(Path::toString),
                                Stream.of(placeOf(Worker.class)))
                        .collect(Collectors.joining(java.io.File.pathSeparator));
        process =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin/java").toString(),
                                "-XX:+UseSerialGC",
                                "-XX:TieredStopAtLevel=1",
                                "-Xmx1g",
                                "-Dfile.encoding=UTF-8",
                                "-Djava.io.tmpdir=" + temporary,
                                "-classpath",
                                classes,
                                Worker.class.getName())
                        .redirectError(errors.toFile())
                        .start();
        calls = new DataOutputStream(process.getOutputStream());
        answers = new DataInputStream(process.getInputStream());
        called = 0;
    }

    private static String placeOf(Class<?> type) {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().getPath())
                .toString();
    }

    private void send(Sandbox sandbox, Call call) throws IOException {
        Worker.write(sandbox.folder().toString(), calls);
        calls.writeInt(call.arguments().size());
        for (String argument : call.arguments()) {
            Worker.write(argument, calls);
        }
        calls.flush();
    }

    private Outcome receive() throws IOException {
        int status = answers.readInt();
        double seconds = answers.readLong() / 1e9;
        String out = Worker.read(answers);
        String err = Worker.read(answers);
        return new Outcome(Optional.of(status), out, err, Worker.read(answers), seconds);
    }

    /** What it is at, for whoever looks for the reason. */
    private String threads() throws IOException {
        Process dump =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin/jstack").toString(),
                                String.valueOf(process.pid()))
                        .redirectErrorStream(true)
                        .start();
        return new String(dump.getInputStream().readAllBytes());
    }

    @Override
    public void close() throws IOException {
        if (process != null) {
            process.destroyForcibly();
            calls = null;
            process = null;
        }
    }
}
