package arcomat.report.verdict;

import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.report.text.OneLine;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Certificates as a file. Below a line {@code certificate} of its own stands for each pair the
 * configuration of the left side, and below it, indented, each configuration of the right side;
 * below a line {@code invariant} both states, and below them, indented, each condition; below a
 * line {@code clauses} {@code never}, and below it, indented, what is never so all at once. A line
 * {@code proof of} says what those below it prove.
 */
public final class CertificateText {
    private static final String FIRST = "arcomat certificates 1";
    private static final String TITLE = "proof of ";
    private static final Map<Form, String> BEGINNINGS =
            Map.of(
                    Form.PAIRS,
                    "certificate",
                    Form.CONDITIONS,
                    "invariant",
                    Form.CLAUSES,
                    "clauses");
    private static final String INDENT = "    ";

    private CertificateText() {}

    /**
     * What certificates prove together.
     *
     * @param title what they are about; empty where the file does not say it
     * @param remarks for the reader
     */
    public record Proof(String title, List<String> remarks, List<Certificate> certificates) {
        public Proof {
            remarks = List.copyOf(remarks);
            certificates = List.copyOf(certificates);
        }
    }

    /**
     * @param left for the reader
     * @param right for the reader
     * @param remarks for the reader
     */
    public static String render(
            String left, String right, List<String> remarks, List<Certificate> certificates) {
        StringBuilder out = new StringBuilder(FIRST + "\n");
        out.append("# ")
                .append(OneLine.of(left))
                .append(" refines ")
                .append(OneLine.of(right))
                .append('\n');
        remark(remarks, out);
        certificates.forEach(each -> append(each, out));
        return out.toString();
    }

    /** Proofs of several things in one file. */
    public static String render(List<Proof> proofs) {
        StringBuilder out = new StringBuilder(FIRST + "\n");
        for (Proof proof : proofs) {
            out.append(TITLE).append(OneLine.of(proof.title)).append('\n');
            remark(proof.remarks, out);
            proof.certificates.forEach(each -> append(each, out));
        }
        return out.toString();
    }

    private static void remark(List<String> remarks, StringBuilder out) {
        remarks.forEach(each -> out.append("# ").append(OneLine.of(each)).append('\n'));
    }

    private static void append(Certificate certificate, StringBuilder out) {
        out.append(BEGINNINGS.get(certificate.form())).append('\n');
        for (Entry entry : certificate.entries()) {
            out.append("  ").append(OneLine.of(entry.left())).append('\n');
            entry.right().forEach(r -> out.append(INDENT).append(OneLine.of(r)).append('\n'));
        }
    }

    /**
     * Empty for a text that is no file of certificates. What stands before the first title is a
     * proof without one.
     */
    public static Optional<List<Proof>> parse(String text) {
        List<String> lines = List.of(text.split("\n"));
        if (!lines.get(0).equals(FIRST)) {
            return Optional.empty();
        }
        List<Titled> proofs = new ArrayList<>(List.of(new Titled("", new ArrayList<>())));
        for (String line : lines.subList(1, lines.size())) {
            List<Reading> certificates = proofs.get(proofs.size() - 1).certificates;
            Optional<Form> beginning = beginning(line);
            if (beginning.isPresent()) {
                certificates.add(new Reading(beginning.get(), new ArrayList<>()));
            } else if (line.startsWith(TITLE)) {
                String title = OneLine.read(line.substring(TITLE.length()));
                proofs.add(new Titled(title, new ArrayList<>()));
            } else if (!line.startsWith("#") && !add(line, certificates)) {
                return Optional.empty();
            }
        }
        return Optional.of(
                proofs.stream()
                        .filter(each -> !each.title.isEmpty() || !each.certificates.isEmpty())
                        .map(Titled::proof)
                        .toList());
    }

    /** A proof as far as it has been read. */
    private record Titled(String title, List<Reading> certificates) {
        Proof proof() {
            return new Proof(
                    title,
                    List.of(),
                    certificates.stream()
                            .map(each -> new Certificate(each.form, each.entries))
                            .toList());
        }
    }

    /** A certificate as far as it has been read. */
    private record Reading(Form form, List<Entry> entries) {}

    private static Optional<Form> beginning(String line) {
        return Stream.of(Form.values()).filter(form -> line.equals(BEGINNINGS.get(form))).findAny();
    }

    private static boolean add(String line, List<Reading> certificates) {
        if (certificates.isEmpty() || !line.startsWith("  ")) {
            return false;
        }
        List<Entry> entries = certificates.get(certificates.size() - 1).entries;
        if (!line.startsWith(INDENT)) {
            entries.add(new Entry(OneLine.read(line.substring(2)), List.of()));
            return true;
        }
        if (entries.isEmpty()) {
            return false;
        }
        Entry last = entries.remove(entries.size() - 1);
        List<String> right = new ArrayList<>(last.right());
        right.add(OneLine.read(line.substring(INDENT.length())));
        entries.add(new Entry(last.left(), right));
        return true;
    }
}
