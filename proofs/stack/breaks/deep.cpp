// A frame of more bytes than its limit.
int main() {
  volatile char bytes[64];
  bytes[0] = 0;
  return bytes[0];
}
