package lejos.nxt;

/** A sensor that is asked over a bus of two wires: it has registers to be read and written. */
public class I2CSensor implements SensorConstants {
    protected static final byte REG_VERSION = 0x00;
    protected static final byte REG_VENDOR_ID = 0x08;
    protected static final byte REG_PRODUCT_ID = 0x10;
    protected static final int DEFAULT_I2C_ADDRESS = 0x02;

    private static final int NAME_LENGTH = 8;
    private static final byte[] NOTHING = {};

    protected I2CPort port;
    protected int address;

    private final byte[] request = new byte[I2CPort.MAX_IO];

    public I2CSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
    }

    public I2CSensor(I2CPort port, int mode) {
        this(port, DEFAULT_I2C_ADDRESS, mode, TYPE_LOWSPEED);
    }

    public I2CSensor(I2CPort port, int address, int mode, int type) {
        this.port = port;
        this.address = address;
        port.setType(type);
        port.i2cEnable(mode);
    }

    public I2CPort getPort() {
        return port;
    }

    public int getAddress() {
        return address;
    }

    /** As on the brick, what is looked at is the address so far. */
    public void setAddress(int addr) {
        if ((address & 1) != 0) {
            throw new IllegalArgumentException("Bad address format");
        }
        address = addr;
    }

    /** Reads registers; negative where that failed. */
    public int getData(int register, byte[] buf, int len) {
        return getData(register, buf, 0, len);
    }

    public int getData(int register, byte[] buf, int offset, int len) {
        request[0] = (byte) register;
        int read = port.i2cTransaction(address, request, 0, 1, buf, offset, len);
        if (read < 0) {
            return read;
        }
        return read == len ? 0 : -1;
    }

    /** Writes registers; negative where that failed. */
    public int sendData(int register, byte[] buf, int len) {
        return sendData(register, buf, 0, len);
    }

    public int sendData(int register, byte[] buf, int offset, int len) {
        if (len >= request.length) {
            throw new IllegalArgumentException();
        }
        request[0] = (byte) register;
        System.arraycopy(buf == null ? NOTHING : buf, offset, request, 1, len);
        return port.i2cTransaction(address, request, 0, len + 1, null, 0, 0);
    }

    public int sendData(int register, byte value) {
        request[0] = (byte) register;
        request[1] = value;
        return port.i2cTransaction(address, request, 0, 2, null, 0, 0);
    }

    public String getVersion() {
        return fetchString(REG_VERSION, NAME_LENGTH);
    }

    public String getVendorID() {
        return fetchString(REG_VENDOR_ID, NAME_LENGTH);
    }

    public String getProductID() {
        return fetchString(REG_PRODUCT_ID, NAME_LENGTH);
    }

    /** The letters before the first zero; none where reading failed. */
    protected String fetchString(byte reg, int len) {
        byte[] letters = new byte[len];
        if (getData(reg, letters, 0, len) != 0) {
            return "";
        }
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < len && letters[i] != 0; i++) {
            text.append((char) (letters[i] & 0xff));
        }
        return text.toString();
    }
}
