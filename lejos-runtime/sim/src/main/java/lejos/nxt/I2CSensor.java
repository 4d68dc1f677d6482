package lejos.nxt;

/** A sensor that is asked over a bus of two wires. */
public class I2CSensor implements SensorConstants {
    protected static final int DEFAULT_I2C_ADDRESS = 2;

    protected I2CPort port;
    protected int address;

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

    public void setAddress(int address) {
        this.address = address;
    }
}
