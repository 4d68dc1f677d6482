package arcomat.cluster.spark;

import arcomat.cli.Embedded;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Properties;

/**
 * Entry point for {@code spark-submit}, with the command line of {@code arcomat campaign}. It names
 * no class of Spark: where there is none, it can still say so.
 */
public final class SparkCampaign {
    /** What Spark says of itself. */
    private static final String ABOUT_SPARK = "/spark-version-info.properties";

    /** Before it, Spark brings a version of ANTLR that cannot read our parser. */
    private static final int OLDEST = 4;

    /** As the command; wrong use. */
    private static final int WRONG_USE = 2;

    /** Who makes the runs is said to {@code spark-submit}. */
    private static final List<String> NOT_HERE =
            List.of("--cluster", "--at", "--secret", "--workers");

    private SparkCampaign() {}

    public static void main(String[] arguments) throws InterruptedException {
        PrintWriter out = writer(System.out);
        PrintWriter err = writer(System.err);
        Optional<String> refusal = refusal(version()).or(() -> refusal(List.of(arguments)));
        int status = refusal.isPresent() ? WRONG_USE : run(arguments, out, err);
        refusal.ifPresent(why -> err.println("arcomat: " + why));
        out.flush();
        err.flush();
        System.exit(status);
    }

    private static PrintWriter writer(PrintStream stream) {
        return new PrintWriter(stream, true, StandardCharsets.UTF_8);
    }

    private static int run(String[] arguments, PrintWriter out, PrintWriter err)
            throws InterruptedException {
        List<String> all = new ArrayList<>(List.of("campaign", "--cluster", "spark"));
        all.addAll(Arrays.asList(arguments));
        return Embedded.run(Path.of("").toAbsolutePath(), out, err, all.toArray(String[]::new));
    }

    /** Empty where there is no Spark. */
    private static String version() {
        try (InputStream in = SparkCampaign.class.getResourceAsStream(ABOUT_SPARK)) {
            Properties about = new Properties();
            if (in != null) {
                about.load(in);
            }
            return about.getProperty("version", "");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Why there is no Spark that can make runs.
     *
     * @param version of Spark; empty where there is none
     */
    static Optional<String> refusal(String version) {
        String major = version.replaceAll("\\..*", "");
        if (version.isEmpty()) {
            return Optional.of(
                    "there is no Spark here: give this jar to spark-submit, with --class "
                            + SparkCampaign.class.getName());
        }
        if (major.matches("\\d{1,4}") && Integer.parseInt(major) < OLDEST) {
            return Optional.of("this is Spark " + version + ", and campaigns need Spark 4");
        }
        return Optional.empty();
    }

    /** Why these arguments of the command have no meaning here. */
    static Optional<String> refusal(List<String> arguments) {
        return arguments.stream()
                .map(each -> each.replaceAll("=.*", ""))
                .filter(NOT_HERE::contains)
                .findFirst()
                .map(
                        each ->
                                "leave out "
                                        + each
                                        + ": who makes the runs is what spark-submit is told by"
                                        + " --master");
    }
}
