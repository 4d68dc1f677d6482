package arcomat.fuzz.process;

import arcomat.cli.Embedded;

import com.sun.management.OperatingSystemMXBean;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * The other end of {@link WarmTool}: runs with the jars of the installation, one command after the
 * other.
 */
final class Worker {
    private Worker() {}

    public static void main(String[] none) throws Exception {
        DataInputStream calls = new DataInputStream(System.in);
        DataOutputStream answers = new DataOutputStream(System.out);
        ByteArrayOutputStream stray = new ByteArrayOutputStream();
        System.setOut(new PrintStream(stray, true, StandardCharsets.UTF_8));
        System.setErr(System.out);
        System.setIn(java.io.InputStream.nullInputStream());
        while (true) {
            Path folder = Path.of(read(calls));
            String[] arguments = new String[calls.readInt()];
            for (int i = 0; i < arguments.length; i++) {
                arguments[i] = read(calls);
            }
            answer(folder, arguments, stray, answers);
        }
    }

    private static void answer(
            Path folder, String[] arguments, ByteArrayOutputStream stray, DataOutputStream answers)
            throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        stray.reset();
        long busy = busy();
        int status = Embedded.run(folder, writer(out), writer(err), arguments);
        answers.writeInt(status);
        answers.writeLong(busy() - busy);
        write(out, answers);
        write(err, answers);
        write(stray, answers);
        answers.flush();
    }

    private static PrintWriter writer(ByteArrayOutputStream stream) {
        return new PrintWriter(stream, false, StandardCharsets.UTF_8);
    }

    private static long busy() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }

    static String read(DataInputStream from) throws IOException {
        return new String(from.readNBytes(from.readInt()), StandardCharsets.UTF_8);
    }

    static void write(String text, DataOutputStream to) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        to.writeInt(bytes.length);
        to.write(bytes);
    }

    private static void write(ByteArrayOutputStream bytes, DataOutputStream to) throws IOException {
        to.writeInt(bytes.size());
        bytes.writeTo(to);
    }
}
