double metres_to_millimetres(double metres) { return metres * 1000.0; }
