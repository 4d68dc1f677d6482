package arcomat.sim.device;

import arcomat.sim.bus.I2CDevice;
import arcomat.sim.time.VirtualTime;

import org.jspecify.annotations.Nullable;

/**
 * The two wires of a socket: takes a request, lets it take its time, and has the device answer when
 * it is over. One device at most is connected. It is the one that somebody has plugged in, or else
 * the one that the program takes it for.
 */
public final class I2CBus {
    /** As leJOS numbers what can go wrong. */
    public static final int NOT_ENABLED = -1;

    public static final int BUSY = -2;
    public static final int NO_ANSWER = -3;
    public static final int TOO_LONG = -4;

    /** Nothing is connected that would keep the wires up. */
    public static final int BUS_BUSY = -5;

    /** Bytes that go one way at once. */
    private static final int MOST = 32;

    private static final int BITS_OF_A_BYTE = 9;

    /** Microseconds; the faster one is for devices that can do it. */
    private static final int BIT = 104;

    private static final int FAST_BIT = 8;

    /** What a request takes besides its bits: one for a byte takes 5 ms, as on the brick. */
    private static final long REST = 5 * VirtualTime.MILLISECOND - 4 * BITS_OF_A_BYTE * BIT;

    private static final long FAST_REST = 500;

    private final SensorSocket socket;
    private final VirtualTime time;
    private final byte[][] written = new byte[MOST + 1][];
    private final byte[][] answers = new byte[MOST + 1][];
    private final byte[] request = new byte[MOST];
    private @Nullable I2CDevice plugged;
    private @Nullable I2CDevice assumed;
    private boolean isConnected;
    private int users;
    private boolean isFast;

    private int address;
    private int sent;
    private int wanted;
    private boolean isOpen;
    private long due;
    private int register;
    private int result;

    I2CBus(SensorSocket socket, VirtualTime time) {
        this.socket = socket;
        this.time = time;
    }

    /** Somebody plugs in a device: whatever the program takes it for, this is what answers. */
    public void plug(I2CDevice device) {
        plugged = device;
        isConnected = true;
    }

    /** A class of leJOS says what it takes the device for. */
    public void assume(I2CDevice device) {
        assumed = device;
    }

    void connect(boolean now) {
        isConnected = now;
    }

    public void enable(boolean fast) {
        if (users++ == 0) {
            isFast = fast;
        }
    }

    public void disable() {
        users = Math.max(0, users - 1);
    }

    /** Whether the wires are free, as a number. */
    public int status() {
        if (users == 0) {
            return NOT_ENABLED;
        }
        if (!isConnected) {
            return BUS_BUSY;
        }
        return time.now() < due ? BUSY : 0;
    }

    /**
     * Begins a request: bytes to the device, the first of which is a register, and bytes back.
     *
     * @param count of the bytes to the device
     * @param readLength of the bytes back
     * @return what is wrong, or 0
     */
    public int start(int newAddress, byte[] bytes, int from, int count, int readLength) {
        int status = status();
        if (status != 0) {
            return status;
        }
        if (count > MOST || readLength > MOST) {
            return TOO_LONG;
        }
        finish();
        address = newAddress;
        sent = count;
        wanted = readLength;
        if (count > 0) {
            System.arraycopy(bytes, from, request, 0, count);
        }
        due = time.now() + duration();
        isOpen = true;
        return 0;
    }

    private long duration() {
        long bytes = 1L + sent + (wanted > 0 ? 1 + wanted : 0);
        return isFast
                ? FAST_REST + bytes * BITS_OF_A_BYTE * FAST_BIT
                : REST + bytes * BITS_OF_A_BYTE * BIT;
    }

    /** When the request will be over; it may be already. */
    public long due() {
        return due;
    }

    /**
     * Takes what the device has answered.
     *
     * @return what is wrong, or how many bytes there are
     */
    public int complete(byte[] bytes, int from, int count) {
        if (users == 0) {
            return NOT_ENABLED;
        }
        if (time.now() < due) {
            return BUSY;
        }
        finish();
        if (result > 0 && count > 0) {
            int taken = Math.min(result, count);
            System.arraycopy(answers[result], 0, bytes, from, taken);
            return taken;
        }
        return result;
    }

    private void finish() {
        if (isOpen) {
            isOpen = false;
            result = exchange();
        }
    }

    private int exchange() {
        if (!isConnected) {
            return NO_ANSWER;
        }
        I2CDevice device = plugged == null ? assumed : plugged;
        socket.checkKnown(device != null);
        if (device == null || device.address() != address) {
            return NO_ANSWER;
        }
        if (sent > 0) {
            register = request[0] & 0xff;
        }
        if (sent > 1) {
            byte[] data = buffer(written, sent - 1);
            System.arraycopy(request, 1, data, 0, sent - 1);
            device.write(register, data, socket);
        }
        if (wanted > 0) {
            device.read(register, buffer(answers, wanted), socket);
        }
        return wanted;
    }

    /** One for each length, kept: programs that ask again and again make no garbage. */
    private static byte[] buffer(byte[][] buffers, int length) {
        if (buffers[length] == null) {
            buffers[length] = new byte[length];
        }
        return buffers[length];
    }
}
